#include "durero/scene/wrap.hpp"

#include "durero/model/operaciones.hpp"
#include "durero/scene/scene.hpp"
#include "support/catch.hpp"

using namespace durero;

TEST_CASE("a triangle keeps how textures lie on it while others come and go, and no other shape has it") {
  scene::Scene scene;
  const auto add = [&](const char* name) {
    scene.apply(model::Agregar_Triangulo{model::Elemento(name), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  };
  add("first");
  add("second");
  const scene::Wrap wrap{{{{0, 1}, {2, 3}, {4, 5}}}};
  scene.set_wrap(*scene.find("second"), wrap);
  CHECK_FALSE(scene.wrap(*scene.find("first")));
  scene.apply(model::Eliminar_Triangulo{model::Elemento("first")});
  REQUIRE(scene.wrap(*scene.find("second")));
  CHECK(*scene.wrap(*scene.find("second")) == wrap);
  scene.apply(model::Eliminar_Triangulo{model::Elemento("second")});
  add("second");
  CHECK_FALSE(scene.wrap(*scene.find("second")));
  scene.apply(model::Agregar_Esfera{model::Elemento("ball"), {0, 0, 0}, 1});
  CHECK_THROWS_AS(scene.set_wrap(*scene.find("ball"), wrap), std::domain_error);
}
