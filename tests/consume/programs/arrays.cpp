// Rays and answers in arrays of one's own: a pencil of them from one point.
#include <durero/engine/arrays.hpp>
#include <durero/model/operaciones.hpp>
#include <iostream>
#include <vector>

using namespace durero;

int main() {
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento("s1"), model::Punto(glm::dvec3(0, 0, 5)), 1});
  const auto engine = engine::find(engine::default_engine)->prepare(scene);
  constexpr std::size_t count = 1000;
  const std::vector<double> zero(count), one(count, 1);
  std::vector<double> across(count);
  for (std::size_t i = 0; i < count; ++i) across[i] = static_cast<double>(i) / 1024;
  std::vector<trace::FirstElement> elements(count);
  std::vector<double> t(count), x(count), y(count), z(count);
  engine::first_hits(*engine, {{zero, zero, zero}, {across, zero, one}}, elements, {t, {x, y, z}});
  std::size_t hits = 0;
  for (const trace::FirstElement& element : elements) hits += element.resultado == model::Resultado::hit;
  std::cout << hits << " of " << count << " rays hit, the last at z = " << z[hits - 1] << '\n';
}
