// A million rays by one call.
#include <durero/engine/engine.hpp>
#include <durero/model/operaciones.hpp>
#include <iostream>

using namespace durero;

int main() {
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento("s1"), model::Punto(glm::dvec3(0, 0, 5)), 1});
  const auto engine = engine::find(engine::default_engine)->prepare(scene);
  std::vector<scene::Query> rays;
  for (int i = 0; i < 1000; ++i) {
    for (int j = 0; j < 1000; ++j) {
      const glm::dvec3 p((i - 500) / 256.0, (j - 500) / 256.0, 0);
      rays.push_back({{model::Punto(p), model::Vector(glm::dvec3(0, 0, 1))}, {}});
    }
  }
  std::size_t hits = 0;
  for (const scene::Hit& hit : engine::first_hits(*engine, rays)) hits += hit.resultado == model::Resultado::hit;
  std::cout << hits << " of " << rays.size() << " rays hit\n";
}
