#include "durero/scene/motion.hpp"

#include <stdexcept>

#include "durero/model/operaciones.hpp"
#include "durero/scene/stage.hpp"
#include "support/catch.hpp"

using namespace durero;

namespace {

/// One element of each way to have points, a ball that rests, and a camera.
scene::Scene moving() {
  scene::Scene scene;
  scene.stage().camera = scene::Camera{{0, 0, -5}, {0, 0, 0}, {0, 1, 0}, 45};
  scene.stage().materials = {{"red", {1, 0, 0}}};
  scene.apply(model::Agregar_Esfera{model::Elemento("rests"), {0, 0, 0}, 1});
  scene.apply(model::Agregar_Esfera{model::Elemento("ball"), {1, 2, 3}, 1});
  scene.apply(model::Agregar_Cono{model::Elemento("cone"), {0, 0, 0}, 0.5, {0, 1, 0}, 2});
  scene.apply(model::Agregar_Triangulo{model::Elemento("leaf"), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  scene.set_material(*scene.find("ball"), 0);
  for (const char* name : {"ball", "cone", "leaf"}) scene.set_motion(*scene.find(name), {4, 0, -2});
  return scene;
}

}  // namespace

TEST_CASE("what moves is a step on at the time 1, and keeps its shape, name, material and row") {
  const scene::Scene scene = moving(), then = scene.at_time(0.5);
  CHECK(scene.at_time(0).shapes<scene::Sphere>()[1].centro == glm::dvec3(1, 2, 3));
  CHECK(then.shapes<scene::Sphere>()[0].centro == glm::dvec3(0));
  CHECK(then.shapes<scene::Sphere>()[1].centro == glm::dvec3(3, 2, 2));
  CHECK(then.shapes<scene::Sphere>()[1].radio == 1);
  CHECK(then.shapes<scene::Cone>()[0].centro == glm::dvec3(2, 0, -1));
  CHECK(then.shapes<scene::Cone>()[0].vector == glm::dvec3(0, 1, 0));
  CHECK(then.shapes<scene::Triangle>()[0].vertices == scene::Corners{glm::dvec3(2, 0, -1), {3, 0, -1}, {2, 1, -1}});
  CHECK(then.find("ball") == scene.find("ball"));
  CHECK(then.material(*then.find("ball")) == 0U);
  CHECK(scene.at_time(1).shapes<scene::Sphere>()[1].centro == glm::dvec3(5, 2, 1));
}

TEST_CASE("the camera moves with eye and look_at") {
  scene::Scene scene = moving();
  scene.stage().camera->motion = {0, 1, 0};
  const scene::Camera camera = *scene.at_time(2).stage().camera;
  CHECK(camera.eye == glm::dvec3(0, 2, -5));
  CHECK(camera.look_at == glm::dvec3(0, 2, 0));
  CHECK(camera.up == glm::dvec3(0, 1, 0));
}

TEST_CASE("a picture is a mean over times where the shutter is open and something moves") {
  scene::Scene scene = moving();
  CHECK(scene::moving_elements(scene) == 3);
  CHECK_FALSE(scene::moves(scene));
  scene.stage().camera->shutter = 1;
  CHECK(scene::moves(scene));
  for (const char* name : {"ball", "cone", "leaf"}) scene.set_motion(*scene.find(name), glm::dvec3(0));
  CHECK(scene::moving_elements(scene) == 0);
  CHECK_FALSE(scene::moves(scene));
  scene.stage().camera->motion = {0, 1, 0};
  CHECK(scene::moves(scene));
}

TEST_CASE("a way beyond the numbers, and a triangle that its rounding makes a line, are refused") {
  scene::Scene scene = moving();
  scene.set_motion(*scene.find("ball"), {1e308, 0, 0});
  CHECK_THROWS_AS(scene.at_time(10), std::domain_error);
  scene = moving();
  scene.set_motion(*scene.find("leaf"), {0x1p60, 0, 0});
  CHECK_THROWS_AS(scene.at_time(1), std::domain_error);
}
