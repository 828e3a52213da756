#include "durero/scene/retrieve.hpp"

#include "durero/model/operaciones.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"
#include "support/model_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;
using scene::Scene;

TEST_CASE("retrieve gives every component") {
  const Punto origin(0, 0, 0);
  const Vector axis(0, 0, 1);
  Escena escena = Init();
  Scene scene;
  const auto add = [&](const Operation& operation) {
    std::visit([&](const auto& in) { model::apply(escena, in); }, operation);
    scene.apply(operation);
  };
  for (const std::string suffix : {"1", "2"}) {
    add(Agregar_Cono{Elemento("cono-of-a-longer-name" + suffix), origin, 0.5, axis, 3});
    add(Agregar_Cilindro{Elemento("cilindro" + suffix), origin, 1, axis, 4});
    add(Agregar_Esfera{Elemento("esfera" + suffix), Punto(1, 2, 3), 2});
  }
  CHECK(retrieve(scene) == escena);
  CHECK(retrieve(Scene()) == Init());
}

TEST_CASE("the order of the elements and their looks are no part of the scene that is retrieved") {
  Scene scene, other;
  const Agregar_Esfera a{Elemento("a"), Punto(0, 0, 0), 1}, b{Elemento("b"), Punto(1, 0, 0), 2};
  scene.apply(a), scene.apply(b);
  other.apply(b), other.apply(a);
  other.stage().materials = {{"red", {1, 0, 0}}};
  other.set_material(*other.find("a"), 0);
  CHECK(retrieve(scene) == retrieve(other));
  other.apply(Eliminar_Elemento{Elemento("a")});
  CHECK_FALSE(retrieve(scene) == retrieve(other));
  CHECK(retrieve(other).elementos == std::set{Elemento("b")});
}
