#include "durero/scene/scene.hpp"

#include "durero/scene/retrieve.hpp"
#include "support/catch.hpp"

using namespace durero;
using model::Elemento;
using model::Operation;
using model::Punto;
using model::Respuesta;
using model::Vector;

TEST_CASE("an element is added, found, and removed") {
  scene::Scene scene;
  CHECK(scene.apply(model::Agregar_Esfera{Elemento("a"), Punto(0, 0, 5), 1}) == Respuesta::esfera_agregada);
  CHECK(scene.apply(model::Agregar_Cilindro{Elemento("b"), Punto(0, 0, 5), 1, Vector(0, 0, 1), 2}) ==
        Respuesta::cilindro_agregado);
  CHECK(scene.apply(model::Agregar_Esfera{Elemento("c"), Punto(1, 0, 5), 2}) == Respuesta::esfera_agregada);
  CHECK(scene.size() == 3);
  REQUIRE(scene.find("c"));
  CHECK(scene.name(*scene.find("c")) == Elemento("c"));
  CHECK_FALSE(scene.find("d"));

  CHECK(scene.apply_total(model::Eliminar_Elemento{Elemento("a")}).r == Respuesta::elemento_eliminado);
  REQUIRE(scene.find("c"));
  CHECK(scene.spheres()[scene.find("c")->index].radio == 2);
  const auto refused = scene.apply_total(model::Eliminar_Esfera{Elemento("b")});
  CHECK(refused.r == Respuesta::tipo_incorrecto);
  REQUIRE(refused.violated);
  CHECK(refused.violated->label == "Eliminar_Esfera.pre.1");
}
