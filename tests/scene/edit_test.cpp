#include "durero/scene/edit.hpp"

#include <stdexcept>

#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"
#include "support/model_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;
using namespace durero::test;
using scene::Scene;

TEST_CASE("e? is the name that an operation speaks of, whichever operation") {
  const Elemento e("e");
  const Punto centro(0, 0, 0);
  const Vector axis(0, 0, 1);
  const Operation every[] = {Agregar_Esfera{e, centro, 1},
                             Agregar_Cilindro{e, centro, 1, axis, 1},
                             Agregar_Cono{e, centro, 1, axis, 1},
                             Eliminar_Esfera{e},
                             Eliminar_Cilindro{e},
                             Eliminar_Cono{e},
                             Eliminar_Elemento{e}};
  for (const Operation& operation : every) {
    INFO(operation.index());
    CHECK(scene::name_of(operation) == e);
  }
}

TEST_CASE("an edit gives the new element its material; one that is refused, or names no material, changes nothing") {
  const Punto origin(0, 0, 0);
  Scene scene;
  scene.stage().materials = {{"blue", {0, 0, 1}}, {"red", {1, 0, 0}}};
  const Agregar_Esfera ball{Elemento("ball"), origin, 1};
  CHECK(scene.apply_total(scene::Edit{ball, 1}).ok());
  CHECK(scene.material(*scene.find("ball")) == 1);
  CHECK_FALSE(scene.apply_total(scene::Edit{ball, 0}).ok());
  CHECK(scene.material(*scene.find("ball")) == 1);
  CHECK_THROWS_AS(scene.apply_total(scene::Edit{Agregar_Esfera{Elemento("other"), origin, 1}, 2}), std::out_of_range);
  CHECK(scene.size() == 1);
}

TEST_CASE("an edit without a material is its operation") {
  Scene by_edit, by_operation;
  const Agregar_Esfera ball{Elemento("ball"), Punto(1, 2, 3), 1};
  CHECK(by_edit.apply_total(scene::Edit{ball}).r == by_operation.apply_total(ball).r);
  CHECK(by_edit.material(*by_edit.find("ball")) == std::nullopt);
  CHECK(by_edit.apply_total(scene::Edit{Eliminar_Elemento{Elemento("ball")}}).r == Respuesta::elemento_eliminado);
  CHECK(by_edit.size() == 0);
}
