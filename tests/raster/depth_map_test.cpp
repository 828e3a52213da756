#include "durero/raster/depth_map.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "durero/engine/engine.hpp"
#include "durero/scene/query.hpp"
#include "raster/triangles.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::raster;
using namespace durero::test;

namespace {

const glm::dvec3 lamp(0.3, 5, -0.2);

/// A floor, and over it a square and a slanted triangle.
scene::Scene floor_and_boards() {
  scene::Scene scene;
  add_square(scene, "floor", {0, 0, 0}, 16);
  add_square(scene, "square", {-1, 2, 0.5}, 1.5);
  add(scene, "slanted", {glm::dvec3(1, 1, -1), {2.5, 1.5, 0}, {1, 2.5, 1}});
  return scene;
}

/// The distance of a point of the plane from a segment.
double distance_from(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const double along = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
  return glm::distance(p, a + along * (b - a));
}

/// Verdicts of a map that differ from those of shadow rays, at points of the floor.
struct Verdicts {
  int asked = 0, different = 0;
  double farthest = 0;  ///< of a point with another verdict, from the edges of what stands before it, in texels
};

Verdicts compared(std::uint32_t size, DepthBias bias) {
  const scene::Scene scene = floor_and_boards();
  const auto polygons = polygons_of(scene, Opacity::opaque);
  const auto corners = corners_of(polygons);
  const DepthMap map(corners, lamp, size);
  const auto engine = engine::find("fast")->prepare(scene);
  Verdicts verdicts;
  for (int i = -60; i <= 60; ++i)
    for (int j = -60; j <= 60; ++j) {
      const glm::dvec3 at(i / 16.0 + 1.0 / 512, 0, j / 16.0 + 1.0 / 512);
      // floor.1 has the corners with x > z.
      const ScenePolygon& floor = *std::ranges::find_if(polygons, [&](const ScenePolygon& one) {
        return scene.name(one.element).name() == (at.x > at.z ? "floor.1" : "floor.2");
      });
      const scene::Query query{{model::Punto(at), model::Vector(lamp - at)}, {floor.element}};
      ++verdicts.asked;
      if (map.is_dark(floor, at, bias) == engine::occluded_segment(*engine, query)) continue;
      ++verdicts.different;
      const DepthTexel texel = map.texel_of(at);
      double nearest = 1e9;
      for (const ScenePolygon& one : polygons) {
        if (scene.name(one.element).name().starts_with("floor")) continue;
        for (int k = 0; k < 3; ++k) {
          const auto a = map.place(texel.face, rounded(one.corners[std::size_t(k)])),
                     b = map.place(texel.face, rounded(one.corners[std::size_t(k + 1) % 3]));
          if (a && b) nearest = std::min(nearest, distance_from(texel.place, *a, *b));
        }
      }
      verdicts.farthest = std::max(verdicts.farthest, nearest);
    }
  return verdicts;
}

}  // namespace

TEST_CASE("with a bias the verdicts differ within a texel's diagonal of a shadow's edge, and ever fewer of them") {
  int last = 10000;
  for (const std::uint32_t size : {32U, 128U, 512U}) {
    const Verdicts verdicts = compared(size, DepthBias::texel);
    INFO(size << " texels: " << verdicts.different << " of " << verdicts.asked << ", " << verdicts.farthest);
    CHECK(verdicts.farthest < std::sqrt(2.0));
    CHECK(verdicts.different < last * 0.6);
    last = verdicts.different;
  }
  CHECK(last < 30);
}

TEST_CASE("without a bias the floor shadows itself, at about half of its points, whatever the size of the map") {
  for (const std::uint32_t size : {32U, 128U, 512U}) {
    const Verdicts verdicts = compared(size, DepthBias::none);
    INFO(size << " texels: " << verdicts.different << " of " << verdicts.asked);
    CHECK(verdicts.different > verdicts.asked / 4);
  }
}

TEST_CASE("oscura.def.1: in the middle of a texel the printed test is right, beside it a plane is dark") {
  scene::Scene scene;
  add_square(scene, "floor", {0, 0, 0}, 16);
  const auto polygons = polygons_of(scene, Opacity::opaque);
  const auto corners = corners_of(polygons);
  const DepthMap map(corners, {0, 1, 0}, 3);  // the middle texel looks straight down
  const DepthTexel texel = map.texel_of({0, 0, 0});
  CHECK(texel.face == 3);
  CHECK(texel.x == 1);
  CHECK(texel.y == 1);
  CHECK(map.depth(texel) == 1);
  CHECK_FALSE(map.is_dark(polygons[0], {0, 0, 0}, DepthBias::none));
  CHECK(map.is_dark(polygons[0], {0.25, 0, 0.125}, DepthBias::none));
  CHECK_FALSE(map.is_dark(polygons[0], {0.25, 0, 0.125}, DepthBias::texel));
  CHECK(std::isinf(map.depth(map.texel_of({0, 3, 0}))));
}

TEST_CASE("the six faces have each direction once") {
  const DepthMap map({}, {0, 0, 0}, 5);
  for (std::size_t face = 0; face < 6; ++face) {
    glm::dvec3 at(0.3, -0.6, 0.1);
    at[int(face / 2)] = face % 2 == 0 ? 2 : -2;
    const DepthTexel texel = map.texel_of(at);
    CHECK(texel.face == face);
    CHECK(glm::distance(map.place(face, at).value(), texel.place) == 0);
    CHECK(std::abs(texel.place.x - texel.x) <= 0.5);
    CHECK(std::abs(texel.place.y - texel.y) <= 0.5);
  }
}
