// Scene files: the canonical text of what was read is a fixed point.
#include "durero/io/json/scene_file.hpp"
#include "fuzz/fuzz.hpp"

using namespace durero;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return test::fuzz([&] {
    const std::string text = io::scene_text(io::read_scene(test::as_source(data, size)));
    test::must(io::scene_text(io::read_scene(io::Source("canonical", text))) == text);
  });
}
