// A predicate that the specification evaluates itself.
#include <durero/model/operaciones.hpp>
#include <durero/scene/retrieve.hpp>
#include <durero/spec/calculator.hpp>
#include <iostream>

using namespace durero;

int main() {
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento("s1"), model::Punto(glm::dvec3(0, 0, 5)), 1});
  const spec::Calculator calculator(scene::retrieve(scene));
  for (const char* predicate : {"s1 ∈ elementos", "mi_radio(s1) ∈ Rmas", "#elementos = 2"})
    std::cout << predicate << ": " << calculator.evaluate(predicate).text << '\n';
}
