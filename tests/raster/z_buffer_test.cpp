#include "durero/raster/z_buffer.hpp"

#include "durero/engine/engine.hpp"
#include "durero/raster/scene_polygons.hpp"
#include "raster/triangles.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::raster;
using namespace durero::test;

TEST_CASE("the nearest polygon of each pixel is what its ray hits first, in scenes whose triangles cross and touch") {
  std::mt19937_64 random(20251127);
  for (int round = 0; round < 12; ++round) {
    scene::Scene scene = grid_scene(random, 20, 2, 2);
    scene.stage().camera->mirrored = round % 3 == 2;
    const auto polygons = polygons_of(scene, Opacity::opaque);
    const RasterView view(*scene.stage().camera, {48, 32});
    const ZBuffer drawn = z_buffer(corners_of(polygons), view);
    const auto engine = engine::find("exact")->prepare(scene);
    std::size_t pixel = 0, met = 0;
    for (std::uint32_t y = 0; y < 32; ++y)
      for (std::uint32_t x = 0; x < 48; ++x, ++pixel) {
        const model::Rayo ray(model::Punto(view.eye()), model::Vector(view.direction(x, y)));
        const scene::Hit hit = engine::first_hit(*engine, {ray});
        const std::uint32_t nearest = drawn.nearest[pixel];
        INFO("round " << round << ", pixel " << x << ", " << y);
        REQUIRE((nearest != ZBuffer::none) == (hit.resultado == model::Resultado::hit));
        if (nearest == ZBuffer::none) continue;
        ++met;
        REQUIRE(std::ranges::count(hit.elementos, polygons[nearest].element) == 1);
        CHECK(drawn.seen[nearest].parameter(view.direction(x, y)) == Approx(hit.t).epsilon(1e-14));
      }
    CHECK(met > 100);
  }
}

TEST_CASE("two polygons at one place: the first of the list is kept") {
  const polygon::Polygon large{{-9, -9, 4}, {9, -9, 4}, {0, 9, 4}}, small{{-1, -1, 4}, {1, -1, 4}, {0, 1, 4}};
  const RasterView view({{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 90}, {9, 9});
  const std::vector<polygon::Polygon> order{small, large}, other{large, small};
  CHECK(z_buffer(order, view).nearest[40] == 0);
  CHECK(z_buffer(other, view).nearest[40] == 0);
  CHECK(z_buffer(order, view).nearest[9 * 7 + 4] == 1);
}

TEST_CASE("a polygon that reaches behind the eye is drawn where it is seen") {
  const polygon::Polygon floor{{-50, -1, -50}, {50, -1, -50}, {0, -1, 90000}};
  const RasterView view({{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 60}, {8, 8});
  const std::vector<polygon::Polygon> all{floor};
  const ZBuffer drawn = z_buffer(all, view);
  for (std::size_t pixel = 0; pixel < 64; ++pixel) CHECK((drawn.nearest[pixel] == 0) == (pixel >= 32));
  CHECK_FALSE(view.place({0, 0, -1}));
  CHECK(view.place({0, 0, 7})->x == Approx(3.5));
  CHECK(view.place(view.eye() + 3.0 * view.direction(6, 1))->y == Approx(1));
}
