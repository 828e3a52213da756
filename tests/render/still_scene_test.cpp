#include "durero/render/still_scene.hpp"

#include "durero/model/operaciones.hpp"
#include "support/catch.hpp"

using namespace durero;

TEST_CASE("a still scene has a camera without a lens, rests, and has point lights that shine all around") {
  scene::Scene scene;
  CHECK_THROWS_WITH(render::still_camera(scene), "the scene has no camera; expected one");
  const scene::Camera camera{{0, 0, -4}, {0, 0, 0}, {0, 1, 0}, 40};
  scene.stage().camera = camera;
  scene.stage().lights = {{.position = {0, 5, 0}, .color = {1, 1, 1}}};
  CHECK(render::still_camera(scene) == camera);
  scene.stage().lights[0].extent = {.shape = scene::LightShape::sphere, .radius = 1};
  CHECK_THROWS_WITH(render::still_camera(scene), "a light has an extent; expected point lights and directions");
  scene.stage().lights[0].extent = {};
  scene.stage().lights[0].cone = {.towards = {0, 0, 0}};
  CHECK_THROWS_WITH(render::still_camera(scene), "a light shines into a cone; expected lights that shine all around");
  scene.stage().lights.clear();
  scene.stage().camera->shutter = 1;
  CHECK(render::still_camera(scene).shutter == 1);  // all rests
  scene.stage().camera->motion = {1, 0, 0};
  CHECK_THROWS_WITH(render::still_camera(scene), "something moves while the shutter is open; expected a scene at rest");
  scene.stage().camera->aperture = 0.5;
  CHECK_THROWS_WITH(render::still_camera(scene), "the camera has a lens; expected a pinhole");
}
