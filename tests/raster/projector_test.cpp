#include "durero/raster/projector.hpp"

#include "durero/raster/raster_scene.hpp"
#include "raster/triangles.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::raster;
using namespace durero::test;

namespace {

/// A picture whose texels tell their place.
scene::TexelImage numbered(std::uint32_t width, std::uint32_t height) {
  scene::TexelImage picture{width, height, {}};
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) picture.texels.emplace_back(x + 1, y + 1, 0);
  return picture;
}

}  // namespace

TEST_CASE("what a texel is thrown on is of that texel, at any distance, and nothing beside or behind the picture") {
  const scene::Camera at{{1, 2, 3}, {1, 2, 9}, {0, 1, 0}, 60};
  const Projector projector(at, numbered(8, 4));
  const RasterView view(at, {8, 4});
  for (std::uint32_t y = 0; y < 4; ++y)
    for (std::uint32_t x = 0; x < 8; ++x)
      for (const double far : {0.25, 1.0, 70.0}) {
        const glm::dvec3 point = at.eye + far * view.direction_at(glm::dvec2(x, y) + 0.4);
        REQUIRE(projector.texel_on(point));
        CHECK(*projector.texel_on(point) == scene::Pixel{x, y});
        CHECK(projector.color_on(point) == glm::dvec3(x + 1, y + 1, 0));
      }
  CHECK_FALSE(projector.texel_on(at.eye + view.direction_at({-0.6, 1})));
  CHECK_FALSE(projector.texel_on(at.eye + view.direction_at({7.6, 1})));
  CHECK_FALSE(projector.texel_on(at.eye - view.direction_at({3, 1})));
  CHECK(projector.color_on(at.eye + view.direction_at({3, 3.6})) == glm::dvec3(0));
}

TEST_CASE("artefacts have the size that the two distances predict, to a fifth") {
  for (const double eye_at : {-2.0, -5.0, -11.0})
    for (const double lamp_at : {-4.0, -12.0}) {
      scene::Scene scene;
      add(scene, "wall", {glm::dvec3(-90, -90, 0), {0, 180, 0}, {90, -90, 0}});
      scene.stage().camera = {{0.1, 0.2, eye_at}, {0.1, 0.2, 0}, {0, 1, 0}, 40};
      const RasterScene raster(scene, {320, 200}, Opacity::opaque);
      const Projector projector({{0, 0, lamp_at}, {0, 0, 0}, {0, 1, 0}, 50}, numbered(96, 64));
      int pixels = 0, runs = 0;
      std::optional<scene::Pixel> last;
      for (std::uint32_t x = 0; x < 320; ++x) {
        const auto texel = projector.texel_on(raster.point(0, x, 100).point);
        if (!texel) continue;
        ++pixels;
        runs += texel != last ? 1 : 0;
        last = texel;
      }
      const double predicted =
          projector.predicted_pixels(raster.point(0, 160, 100).point, *scene.stage().camera, {320, 200});
      INFO("eye " << eye_at << ", lamp " << lamp_at << ": " << predicted << ", " << double(pixels) / runs);
      CHECK(predicted == Approx(double(pixels) / runs).epsilon(0.2));
    }
}
