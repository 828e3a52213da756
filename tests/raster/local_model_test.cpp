#include "durero/raster/local_model.hpp"

#include "durero/engine/engine.hpp"
#include "durero/raster/raster_scene.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/scene/query.hpp"
#include "raster/triangles.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::raster;
using namespace durero::test;

TEST_CASE("the colour of a point is the one that its ray brings, by code of its own") {
  std::mt19937_64 random(20251128);
  for (int round = 0; round < 6; ++round) {
    const scene::Scene scene = grid_scene(random, 12, 2, 2);
    const RasterScene raster(scene, {24, 16}, Opacity::opaque);
    const auto engine = engine::find("exact")->prepare(scene);
    for (std::uint32_t y = 0; y < 16; ++y)
      for (std::uint32_t x = 0; x < 24; ++x) {
        const std::size_t pixel = std::size_t(y) * 24 + x;
        if (raster.nearest(pixel) == ZBuffer::none) continue;
        const RasterPoint at = raster.point(raster.nearest(pixel), x, y);
        const LightColors lights = lights_by_rays(scene.stage(), *engine, {at}).at(0);
        const scene::Query query{{model::Punto(raster.view().eye()), model::Vector(raster.view().direction(x, y))}};
        const glm::dvec3 brought = render::brought(scene, *engine, {&query, 1}, {1}).at(0).color;
        const glm::dvec3 own = local_color(scene.stage(), at, lights);
        for (int i = 0; i < 3; ++i) CHECK(own[i] == Approx(brought[i]).epsilon(1e-12));
      }
  }
}

TEST_CASE("a light that is not seen adds nothing, and one behind the surface its even share") {
  scene::Stage stage;
  stage.lights = {{{0, 2, 0}, {1, 1, 1}}, {{0, -2, 0}, {0.5, 0.5, 0.5}}};
  ScenePolygon floor{};
  floor.normal = {0, -1, 0};
  floor.material = {.color = {0.5, 0.5, 0.5}, .k_a = 0.25, .k_d = 0.5, .emission = {0.125, 0, 0}};
  const RasterPoint at{&floor, {0, 0, 0}, {0, -1, 1}};
  CHECK(local_color(stage, at, {glm::dvec3(0), glm::dvec3(0)}) == glm::dvec3(0.125, 0, 0));
  CHECK(local_color(stage, at, {glm::dvec3(1), glm::dvec3(0)}) == glm::dvec3(0.5, 0.375, 0.375));
  CHECK(local_color(stage, at, colors_of(stage)) == glm::dvec3(0.5625, 0.4375, 0.4375));
}
