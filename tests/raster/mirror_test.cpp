#include "durero/raster/mirror.hpp"

#include <stdexcept>

#include "durero/model/operaciones.hpp"
#include "durero/raster/difference.hpp"
#include "durero/render/output/tone.hpp"
#include "durero/render/render.hpp"
#include "raster/triangles.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::raster;
using namespace durero::test;

namespace {

/// A mirror of each flat shape by its name, and a ball before and one behind it.
scene::Scene mirrored_room() {
  scene::Scene scene;
  scene::Stage& stage = scene.stage();
  stage.camera = {{0.5, 0.4, -6}, {0, 0.2, 1}, {0, 1, 0}, 50};
  stage.background = glm::dvec3(0.2, 0.3, 0.5);
  stage.lights = {{{-4, 5, -5}, {1, 1, 0.9}}};
  stage.materials = {{.name = "mirror", .color = {0.25, 0, 0}, .k_d = 0.5, .k_ps = 0.75, .M_PS = {1, 0.9, 0.9}},
                     {.name = "red", .color = {0.9, 0.1, 0.1}},
                     {.name = "sheet", .color = {0, 0, 0}, .k_ps = 0.5, .k_t = 0.25}};
  using model::Elemento;
  scene.apply(model::Agregar_Esfera{Elemento("ball"), {0.3, 0.3, -0.6}, 0.7});
  scene.apply(model::Agregar_Esfera{Elemento("behind"), {0, 0, 8}, 2});
  scene.set_material(*scene.find("ball"), 1);
  scene.set_material(*scene.find("behind"), 1);
  return scene;
}

void check_mirror(scene::Scene& scene) {
  scene.set_material(*scene.find("mirror"), 0);
  const auto engine = engine::find("fast")->prepare(scene);
  render::RenderSettings frame;
  frame.size = {96, 64};
  frame.max_depth = 3;
  const render::Image own = render::toned(by_second_camera(scene, *engine, {96, 64}, "mirror", 3), render::Tone::clamp),
                      rays = render::toned(render::render(scene, *engine, {}, frame), render::Tone::clamp);
  CHECK(difference(own, rays).greatest <= 1);
  frame.max_depth = 1;
  CHECK(difference(own, render::toned(render::render(scene, *engine, {}, frame), render::Tone::clamp)).pixels > 150);
}

}  // namespace

TEST_CASE("the picture in two passes is the one that rays trace, to 1/255, for each flat shape") {
  using model::Elemento;
  scene::Scene plane = mirrored_room(), disc = mirrored_room(), triangle = mirrored_room();
  plane.apply(model::Agregar_Plano{Elemento("mirror"), {0, 0, 2}, {0.6, 0, -0.8}});
  check_mirror(plane);
  disc.apply(model::Agregar_Disco{Elemento("mirror"), {0, 0, 2}, 1.5, {0.6, 0, -0.8}});
  check_mirror(disc);
  triangle.apply(model::Agregar_Triangulo{Elemento("mirror"), {{-3, -2, 1}, {3, -2, 2}, {0, 3, 2}}});
  check_mirror(triangle);
}

TEST_CASE("what is no mirror is refused, and named") {
  scene::Scene scene = mirrored_room();
  scene.apply(model::Agregar_Plano{model::Elemento("sheet"), {0, 0, 2}, {0, 0, 1}});
  scene.set_material(*scene.find("sheet"), 2);
  const auto engine = engine::find("fast")->prepare(scene);
  const auto draw = [&](const char* name) { return by_second_camera(scene, *engine, {4, 3}, name, 2); };
  CHECK_THROWS_WITH(draw("nothing"), Catch::Contains("no element is called nothing"));
  CHECK_THROWS_WITH(draw("behind"), Catch::Contains("element behind mirrors nothing"));
  CHECK_THROWS_WITH(draw("sheet"), Catch::Contains("element sheet is more than a mirror"));
  scene.set_material(*scene.find("ball"), 0);
  CHECK_THROWS_WITH(draw("ball"), Catch::Contains("element ball is not flat"));
  scene.stage().camera.reset();
  CHECK_THROWS_WITH(draw("ball"), Catch::Contains("no camera"));
}
