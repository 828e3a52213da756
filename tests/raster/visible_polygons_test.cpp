#include "durero/raster/visible_polygons.hpp"

#include <cmath>
#include <glm/common.hpp>

#include "durero/raster/scene_polygons.hpp"
#include "durero/raster/shadow_polygons.hpp"
#include "raster/triangles.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::raster;
using namespace durero::test;
using polygon::Rational;
using polygon::RationalPoint;

namespace {

RationalPoint area_of(const std::vector<polygon::Polygon>& parts) {
  RationalPoint sum{};
  for (const polygon::Polygon& part : parts) sum = sum + polygon::doubled_area(part);
  return sum;
}

/// Whether what is lit by one technique is lit by the other: the areas are the same, and no part reaches into a shadow.
void check_same_union(const std::vector<polygon::Polygon>& corners, const polygon::Apex& light) {
  const ShadowPolygons shadows = shadow_polygons(corners, light);
  const VisiblePolygons visible = visible_polygons(corners, light);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    CHECK(area_of(visible.parts[i]) == area_of(lit_parts(shadows, corners, i)));
    const polygon::Apex across{polygon::doubled_area(corners[i]), true};
    for (const ShadowPolygon& shadow : shadows.all)
      if (shadow.receiver == i)
        for (const polygon::Polygon& part : visible.parts[i])
          CHECK(polygon::clipped(part, polygon::pyramid(across, shadow.corners)).empty());
  }
}

}  // namespace

TEST_CASE("what is left is what shadow polygons leave, with no difference of area, also where polygons cross") {
  std::mt19937_64 random(20251130);
  for (int round = 0; round < 8; ++round) {
    const auto corners = corners_of(polygons_of(grid_scene(random, 12, 1, 2), Opacity::opaque));
    check_same_union(corners, {{Rational(1, 3), 5, 0}});
    check_same_union(corners, {{0, 0, Rational(1, 16)}});  // among them
    check_same_union(corners, {{1, 4, Rational(1, 7)}, true});
  }
}

TEST_CASE("three boards that lie on each other around are cut right, which no order of theirs does") {
  std::vector<polygon::Polygon> boards;
  boards.push_back({{-4, 1, -1}, {4, -1, -1}, {4, -1, 0}, {-4, 1, 0}});
  boards.push_back({{2, 1, -3}, {-1, -1, 4}, {-2, -1, 4}, {1, 1, -3}});
  boards.push_back({{-3, -1, -2}, {2, 1, 4}, {3, 1, 4}, {-2, -1, -2}});
  check_same_union(boards, {{0, 20, 0}});
  check_same_union(boards, {{0, 1, 0}, true});
}

TEST_CASE("a polygon that is hidden is passed over, and clips nothing") {
  const auto level = [](int half, int height) {
    return polygon::Polygon{{-half, height, -half}, {half, height, -half}, {half, height, half}, {-half, height, half}};
  };
  const std::vector<polygon::Polygon> pile{level(1, 0), level(1, 1), level(9, 2), level(1, -1)};
  const VisiblePolygons visible = visible_polygons(pile, {{0, 5, 0}});
  CHECK(visible.clips == 3);
  CHECK(visible.parts[2] == std::vector<polygon::Polygon>{pile[2]});
  for (const std::size_t i : {0U, 1U, 3U}) CHECK(visible.parts[i].empty());
}

namespace {

/// A random triangle in a cube: its corners anywhere, or within a size of a place of it, in 256ths.
polygon::Polygon scattered(std::mt19937_64& random, double size) {
  for (;;) {
    const bool is_anywhere = size == 0;
    const glm::dvec3 middle = is_anywhere ? glm::dvec3(0) : grid_point(random, 4);
    polygon::Polygon corners;
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 aside = is_anywhere ? grid_point(random, 4) : grid_point(random, 1) * size;
      corners.push_back(polygon::exact(middle + glm::round(aside * 256.0) / 256.0));
    }
    if (polygon::doubled_area(corners) != RationalPoint{}) return corners;
  }
}

/// The slope of the logarithm of the clips over that of the number of polygons, fitted.
double fitted_slope(double (*size_of)(int count)) {
  std::mt19937_64 random(20251201);
  double sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0, n = 0;
  for (const int count : {25, 50, 100, 200, 400}) {
    std::vector<polygon::Polygon> all;
    for (int i = 0; i < count; ++i) all.push_back(scattered(random, size_of(count)));
    const double x = std::log(count), y = std::log(double(visible_polygons(all, {{Rational(1, 3), 14, 0}}).clips));
    sum_x += x, sum_y += y, sum_xx += x * x, sum_xy += x * y, ++n;
  }
  return (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
}

}  // namespace

TEST_CASE("clips grow slower than the square of the number of polygons in random scenes") {
  const double ever_more = fitted_slope([](int) { return 0.0; });
  const double ever_finer = fitted_slope([](int count) { return 6 / std::sqrt(count); });
  INFO("slopes " << ever_more << " of ever more polygons, " << ever_finer << " of ever finer ones");
  CHECK(ever_more < 1.7);
  CHECK(ever_finer < 1.2);
  CHECK(ever_finer > 0.8);
}
