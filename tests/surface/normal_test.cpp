#include "durero/surface/normal.hpp"

#include <cmath>

#include "durero/model/operaciones.hpp"
#include "support/catch.hpp"

using namespace durero;

TEST_CASE("normals are gradients of the power, on each type") {
  scene::Scene scene;
  scene.apply(model::Agregar_Esfera{model::Elemento("s"), {1, 2, 3}, 2});
  scene.apply(model::Agregar_Cilindro{model::Elemento("c"), {0, 0, 0}, 1, {0, 1, 0}, 2});
  scene.apply(model::Agregar_Cono{model::Elemento("k"), {0, 0, 0}, 1, {0, 1, 0}, 1});
  using model::Tipo;
  CHECK(surface::normal(scene, {Tipo::soy_esfera, 0}, {3, 2, 3}) == glm::dvec3(1, 0, 0));
  CHECK(surface::normal(scene, {Tipo::soy_cilindro, 0}, {0, 1.5, -1}) == glm::dvec3(0, 0, -1));
  const glm::dvec3 n = surface::normal(scene, {Tipo::soy_cono, 0}, {0.5, 0.5, 0});
  CHECK(n.x == Approx(std::sqrt(0.5)));
  CHECK(n.y == Approx(std::sqrt(0.5)));
  CHECK(surface::normal(scene, {Tipo::soy_cono, 0}, {0, 1, 0}) == glm::dvec3(0, 1, 0));  // the apex: the axis
}
