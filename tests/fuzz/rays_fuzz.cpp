// Ray files, as text and as .npy: what was read is written so that it reads back.
#include "durero/io/rays/rays_file.hpp"
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
    const auto rays = io::read_rays(test::as_source(data, size), scene);
    test::must(io::read_rays(io::Source("text", io::rays_text(rays, scene)), scene) == rays);
  });
}
