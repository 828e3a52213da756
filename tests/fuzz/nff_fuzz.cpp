// NFF files: what was imported is a scene that can be written and read, and be exported again.
#include "durero/io/json/scene_file.hpp"
#include "durero/io/nff/nff.hpp"
#include "durero/scene/stage.hpp"
#include "fuzz/fuzz.hpp"

using namespace durero;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return test::fuzz([&] {
    const io::Imported imported = io::read_nff(test::as_source(data, size));
    const std::string text = io::scene_text(imported.scene);
    test::must(io::scene_text(io::read_scene(io::Source("canonical", text))) == text);
    test::must(!imported.scene.stage().camera || !io::nff_text(imported.scene).text.empty());
  });
}
