#include "durero/raster/raster_scene.hpp"

#include <stdexcept>

#include "durero/render/output/tone.hpp"
#include "durero/render/render.hpp"
#include "raster/triangles.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::raster;
using namespace durero::test;

TEST_CASE("a raster with the lights that rays see is the picture by rays, to a byte") {
  std::mt19937_64 random(20251202);
  for (int round = 0; round < 5; ++round) {
    scene::Scene scene = grid_scene(random, 25, 2, 2);
    scene.stage().camera->mirrored = round == 4;
    const auto engine = engine::find("fast")->prepare(scene);
    const RasterScene raster(scene, {96, 64}, Opacity::opaque);
    const render::Picture own = raster.shaded(
        [&](std::size_t, const RasterPoint& at) { return lights_by_rays(scene.stage(), *engine, {at}).at(0); });
    const auto bytes = [](const render::Picture& picture) { return render::toned(picture, render::Tone::clamp).rgb; };
    CHECK(bytes(own) == bytes(render::render(scene, *engine)));
  }
}

TEST_CASE("transparent polygons are seen, and hide nothing") {
  std::mt19937_64 random(3);
  scene::Scene scene = grid_scene(random, 0, 1);
  scene.stage().materials.push_back({.name = "sheet", .k_t = 0.5});
  add(scene, "near", {glm::dvec3(-9, -9, -1), {9, -9, -1}, {0, 9, -1}}, 2);
  add(scene, "opaque", {glm::dvec3(-9, -9, 1), {9, -9, 1}, {0, 9, 1}}, 0);
  const RasterScene raster(scene, {5, 5}, Opacity::transparent);
  CHECK(raster.nearest(12) == 1);
  CHECK(raster.point(0, 2, 2).point.z == Approx(-1));
  CHECK(raster.point(1, 2, 2).point.z == Approx(1));
}

TEST_CASE("a scene without a camera is refused, and one that an environment surrounds") {
  scene::Scene scene;
  CHECK_THROWS_WITH(RasterScene(scene, {2, 2}, Opacity::opaque), Catch::Contains("no camera"));
  scene.stage().camera = {{0, 0, -1}, {0, 0, 0}, {0, 1, 0}, 40};
  CHECK(RasterScene(scene, {2, 2}, Opacity::opaque).background() == glm::dvec3(0));
  scene.stage().environment = scene::Environment{};
  CHECK_THROWS_WITH(RasterScene(scene, {2, 2}, Opacity::opaque), Catch::Contains("environment"));
}

TEST_CASE("a lens, a motion, a light with an extent and normals of vertices are refused") {
  std::mt19937_64 random(4);
  scene::Scene scene = grid_scene(random, 2, 1);
  const auto draw = [&] { return RasterScene(scene, {2, 2}, Opacity::opaque); };
  scene.stage().camera->aperture = 0.5;
  CHECK_THROWS_WITH(draw(), Catch::Contains("the camera has a lens"));
  scene.stage().camera->aperture = 0;
  scene.stage().camera->shutter = 1;
  CHECK(draw().polygons().size() == 2);  // all rests
  scene.stage().camera->motion = {1, 0, 0};
  CHECK_THROWS_WITH(draw(), Catch::Contains("something moves"));
  scene.stage().camera->shutter = 0;
  scene.stage().lights[0].extent = {.shape = scene::LightShape::sphere, .radius = 1};
  CHECK_THROWS_WITH(draw(), Catch::Contains("a light has an extent"));
  scene.stage().lights[0].extent = {};
  scene.stage().lights[0].cone = {.towards = {0, 0, 0}};
  CHECK_THROWS_WITH(draw(), Catch::Contains("a light shines into a cone; expected lights that shine all around"));
  scene.stage().lights[0].cone.reset();
  scene.set_vertex_normals(*scene.find("t100"), {glm::dvec3(0, 1, 0), {0, 1, 0}, {1, 1, 0}});
  CHECK_THROWS_WITH(draw(), Catch::Contains("element t100 is shaded by normals of its own"));
}
