// glTF scenes, as text or binary: what was imported is a scene that can be written and read.
#include "durero/io/json/scene_file.hpp"
#include "durero/io/mesh/gltf.hpp"
#include "fuzz/fuzz.hpp"

using namespace durero;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return test::fuzz([&] {
    const std::string text = io::scene_text(io::read_gltf(test::as_source(data, size)).scene);
    test::must(io::scene_text(io::read_scene(io::Source("canonical", text))) == text);
  });
}
