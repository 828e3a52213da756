// Hit files: what was read is written so that it reads back.
#include "durero/io/rays/hits_file.hpp"
#include "durero/model/operaciones.hpp"
#include "fuzz/fuzz.hpp"

using namespace durero;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const scene::Scene scene = [] {
    scene::Scene s;
    s.apply(model::Agregar_Esfera{model::Elemento{"a"}, model::Punto{0, 0, 0}, 1});
    s.apply(model::Agregar_Esfera{model::Elemento{"b"}, model::Punto{0, 0, 0}, 1});
    return s;
  }();
  return test::fuzz([&] {
    for (const io::RayHit& read : io::read_hits(test::as_source(data, size), scene)) {
      const io::Source line("text", io::hit_text(read.ray, read.hit, scene));
      test::must(io::read_hits(line, scene).at(0).hit == read.hit);
    }
  });
}
