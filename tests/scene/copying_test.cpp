#include "durero/scene/copying.hpp"

#include <stdexcept>

#include "durero/model/operaciones.hpp"
#include "durero/scene/body.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using scene::Copying;
using scene::CopyRemoval;

namespace {

const model::Mapa wide{{0, 0, 5}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const model::Mapa flat{{0, 0, 5}, {2, 0, 0}, {4, 0, 0}, {0, 0, 1}};

scene::Scene with_ball() {
  scene::Scene scene;
  test::add(scene, model::Elemento("ball"), scene::Sphere{{1, 0, 0}, 3});
  return scene;
}

std::string answer(const scene::Outcome& outcome) {
  return std::string(outcome.r) + (outcome.ok() ? "" : " " + std::string(outcome.violated->label));
}

const scene::Instance& instance(const scene::Scene& scene, const char* name) {
  return std::get<scene::Instance>(scene.body(*scene.find(name))->form);
}

}  // namespace

TEST_CASE("An instance is the copy of an element, or of an instance, and outlives its original") {
  scene::Scene scene = with_ball();
  CHECK(answer(apply_total(scene, Copying{"pebble", "ball", wide})) == "instancia_agregada");
  CHECK(answer(apply_total(scene, Copying{"second", "pebble", wide})) == "instancia_agregada");
  scene.apply(model::Eliminar_Esfera{model::Elemento("ball")});
  CHECK(instance(scene, "pebble").mapa == wide);
  CHECK(std::get<scene::Sphere>(instance(scene, "pebble").shape).radio == 3);
  CHECK(instance(scene, "second").mapa == model::compuesto(wide, wide));
  CHECK(scene.size() == 2);
}

TEST_CASE("Agregar_Instancia.pre.1, Agregar_Instancia.pre.2, Mapa.inv.1: what is refused changes nothing") {
  scene::Scene scene = with_ball();
  CHECK(answer(apply_total(scene, Copying{"ball", "none", flat})) == "elemento_ya_existe Agregar_Instancia.pre.1");
  CHECK(answer(apply_total(scene, Copying{"pebble", "none", flat})) == "elemento_no_existe Agregar_Instancia.pre.2");
  CHECK(answer(apply_total(scene, Copying{"pebble", "ball", flat})) == "mapa_singular Mapa.inv.1");
  CHECK_THROWS_AS(apply_total(scene, Copying{"pebble", "ball", wide, 7}), std::out_of_range);
  CHECK(scene.size() == 1);
  CHECK_FALSE(scene.has_bodies());
}

TEST_CASE("Eliminar_Instancia.pre.1, Eliminar_Instancia.pre.2: instances alone are removed as such") {
  scene::Scene scene = with_ball();
  apply_total(scene, Copying{"pebble", "ball", wide});
  CHECK(answer(apply_total(scene, CopyRemoval{"none"})) == "elemento_no_existe Eliminar_Instancia.pre.1");
  CHECK(answer(apply_total(scene, CopyRemoval{"ball"})) == "tipo_incorrecto Eliminar_Instancia.pre.2");
  CHECK(scene.size() == 2);
  CHECK(answer(apply_total(scene, CopyRemoval{"pebble"})) == "instancia_eliminada");
  CHECK(scene.size() == 1);
}
