#pragma once
/// The scene that most pictures of the tests are of.

#include "durero/model/operaciones.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"

namespace durero::test {

/// A unit ball at the origin, red, lit from above.
inline scene::Scene lit_ball() {
  scene::Scene scene;
  scene.stage().materials = {{"red", {1, 0, 0}}};
  scene.stage().lights = {{{0, 10, 0}, {1, 0.5, 0.25}}};
  scene.apply(model::Agregar_Esfera{model::Elemento("ball"), {0, 0, 0}, 1});
  scene.set_material(*scene.find("ball"), 0);
  return scene;
}

}  // namespace durero::test
