// A scene edited under contract, with a violation handler of one's own.
#include <durero/contract/contract.hpp>
#include <durero/model/operaciones.hpp>
#include <durero/scene/scene.hpp>
#include <iostream>

using namespace durero;

namespace {

/// A handler must not return where clauses are enforced.
void tell(const contract::contract_violation& violation) {
  std::cout << "broken: " << violation.label() << '\n';
  throw violation;
}

}  // namespace

int main() {
  contract::set_violation_handler(tell);
  scene::Scene scene;
  const model::Agregar_Esfera sphere{model::Elemento("s1"), model::Punto(glm::dvec3(0, 0, 5)), 1};
  scene.apply(sphere);
  try {
    scene.apply(sphere);
  } catch (const contract::contract_violation& violation) {
    std::cout << violation.predicate() << ", and still " << scene.size() << " element\n";
  }
  const model::Answer answer = scene.apply_total(model::Eliminar_Esfera{model::Elemento("s2")});
  std::cout << "refused: " << answer.violated->label << '\n';
}
