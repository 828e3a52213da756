// POV-Ray's language: what was imported is a scene, with groups, that can be written and read; so it is with surfaces
// that a Z text declares.
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/pov/algebraic.hpp"
#include "durero/io/pov/pov.hpp"
#include "fuzz/fuzz.hpp"

using namespace durero;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return test::fuzz([&] {
    const io::Imported imported = io::read_pov(test::as_source(data, size));
    const std::string text = io::scene_text(imported.scene, imported.groups);
    const scene::GroupedScene read = io::read_grouped_scene(io::Source("canonical", text));
    test::must(io::scene_text(read.scene, read.groups) == text);
    test::must(!io::pov_text(imported.scene, imported.groups).text.empty());
    io::Source whole = test::as_source(data, size);
    whole.set_keeps_surfaces(true);
    const io::Imported kept = io::read_pov(whole);
    const std::string written = io::scene_text(kept.scene, kept.groups, {io::algebraic_types(), &kept.surfaces});
    std::vector<io::WrittenElement> elements;
    const scene::Scene again =
        io::read_scene(io::Source("canonical", written), io::algebraic_types(), elements, io::Bodies::read);
    test::must(again.size() == kept.scene.size() && elements.size() == kept.surfaces.size());
  });
}
