#include "durero/raster/shadow_polygons.hpp"

#include "durero/engine/engine.hpp"
#include "durero/raster/scene_polygons.hpp"
#include "durero/scene/query.hpp"
#include "raster/triangles.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

using namespace durero;
using namespace durero::raster;
using namespace durero::test;
using polygon::Rational;
using polygon::RationalPoint;

namespace {

polygon::Polygon level_square(const Rational& half, const Rational& height) {
  return {{-half, height, -half}, {half, height, -half}, {half, height, half}, {-half, height, half}};
}

}  // namespace

TEST_CASE("the shadow of a square on a plane has (h/(h − d))² of its area, exactly") {
  const std::vector<polygon::Polygon> polygons{level_square(100, 0), level_square(1, Rational(1, 3))};
  const ShadowPolygons shadows = shadow_polygons(polygons, {{Rational(1, 7), 2, 0}});
  CHECK(shadows.pairs == 2);
  REQUIRE(shadows.all.size() == 1);
  CHECK(shadows.all[0].caster == 1);
  CHECK(shadows.all[0].receiver == 0);
  const Rational times = Rational(2) / (2 - Rational(1, 3));
  CHECK(polygon::doubled_area(shadows.all[0].corners) == (times * times) * polygon::doubled_area(polygons[1]));
}

TEST_CASE("every ordered pair is projected, and a polygon edge-on throws nothing") {
  std::mt19937_64 random(5);
  const auto polygons = corners_of(polygons_of(grid_scene(random, 13, 2, 2), Opacity::opaque));
  CHECK(shadow_polygons(polygons, {{0, 9, 0}}).pairs == 13 * 12);
  const std::vector<polygon::Polygon> two{level_square(9, 0), level_square(1, 3)};
  CHECK(shadow_polygons(two, {{7, 3, 0}}).all.empty());
}

TEST_CASE("the verdict of each shadow ray is that of the polygons, at 10^5 points of random scenes") {
  std::mt19937_64 random(20251129);
  std::size_t points = 0, dark = 0;
  const std::size_t most = fewer_when_sanitized(100000);
  while (points < most) {
    const scene::Scene scene = grid_scene(random, 8, 1, 2);
    const auto polygons = polygons_of(scene, Opacity::opaque);
    const auto corners = corners_of(polygons);
    const polygon::Apex lamp = apexes_of(scene.stage()).at(0);
    const auto is_edge_on = [&](const polygon::Polygon& one) { return !polygon::side_of(lamp, one); };
    if (std::ranges::any_of(corners, is_edge_on)) continue;  // what throws no area may throw a line
    const ShadowPolygons shadows = shadow_polygons(corners, lamp);
    const auto engine = engine::find("fast")->prepare(scene);
    for (std::size_t i = 0; i < polygons.size(); ++i)
      for (int k = 0; k < 500 && points < most; ++k, ++points) {
        const glm::dvec3 at = point_of(random, scene.shapes<scene::Triangle>()[polygons[i].element.index].vertices);
        const scene::Query query{{model::Punto(at), model::Vector(scene.stage().lights[0].position - at)},
                                 {polygons[i].element}};
        const bool is_dark = engine::occluded_segment(*engine, query);
        dark += is_dark ? 1 : 0;
        INFO("point " << points << ": " << at.x << ", " << at.y << ", " << at.z);
        REQUIRE(is_in_shadow(shadows, corners, i, polygon::exact(at)) == is_dark);
      }
  }
  CHECK(dark > points / 20);
  CHECK(dark < points - points / 20);
}

TEST_CASE("the parts outside all shadows lie in none") {
  std::mt19937_64 random(6);
  for (int round = 0; round < 10; ++round) {
    const auto corners = corners_of(polygons_of(grid_scene(random, 8, 1, 2), Opacity::opaque));
    const ShadowPolygons shadows = shadow_polygons(corners, {{0, 9, Rational(1, 2)}});
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (const polygon::Polygon& part : lit_parts(shadows, corners, i)) {
        RationalPoint sum{};
        for (const RationalPoint& corner : part) sum = sum + corner;
        CHECK_FALSE(is_in_shadow(shadows, corners, i, (1 / Rational(part.size())) * sum));
      }
  }
}
