// Scenes of pbrt: what was imported is a scene, with groups, that can be written and read.
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/pbrt/pbrt.hpp"
#include "fuzz/fuzz.hpp"

using namespace durero;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return test::fuzz([&] {
    const io::Imported imported = io::read_pbrt(test::as_source(data, size));
    const std::string text = io::scene_text(imported.scene, imported.groups);
    const scene::GroupedScene read = io::read_grouped_scene(io::Source("canonical", text), io::Bodies::read);
    test::must(io::scene_text(read.scene, read.groups) == text);
  });
}
