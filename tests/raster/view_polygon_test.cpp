#include "durero/raster/view_polygon.hpp"

#include <cmath>

#include "durero/raster/scene_polygons.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::raster;

namespace {

polygon::Polygon triangle_at(double z) {
  return {polygon::exact({-1, -1, z}), polygon::exact({1, -1, z}), polygon::exact({0, 1, z})};
}

}  // namespace

TEST_CASE("a ray meets edges and corners, and what lies a step of the last place beside them it does not") {
  const ViewPolygon seen(triangle_at(4), {0, 0, 0});
  CHECK(seen.is_met({0, 0, 1}));
  CHECK(seen.is_met({0, -1, 4}));
  CHECK(seen.is_met({-1, -1, 4}));
  CHECK(seen.is_met({0, 0.25, 1}));
  CHECK_FALSE(seen.is_met({0, std::nextafter(0.25, 1), 1}));
  CHECK_FALSE(seen.is_met({0, -1, std::nextafter(4.0, 0)}));
  CHECK(seen.is_met({0, -1, std::nextafter(4.0, 5)}));
  CHECK_FALSE(seen.is_met({0, 0, -1}));
  CHECK(seen.parameter({0, 0, 2}) == 2);
}

TEST_CASE("the nearer of two planes is known exactly, and of equal ones neither") {
  const ViewPolygon near(triangle_at(4), {0, 0, 0}), far(triangle_at(std::nextafter(4.0, 5)), {0, 0, 0});
  const glm::dvec3 v(0.0625, 0.03, 1);
  CHECK(near.is_before(far, v));
  CHECK_FALSE(far.is_before(near, v));
  CHECK_FALSE(near.is_before(near, v));
}

TEST_CASE("from a point of its plane a polygon is not seen") {
  CHECK(ViewPolygon(triangle_at(4), {9, 0, 4}).is_edge_on());
  CHECK_FALSE(ViewPolygon(triangle_at(4), {9, 0, 4}).is_met({-1, 0, 0}));
  CHECK_FALSE(ViewPolygon(triangle_at(4), {9, 0, 3}).is_edge_on());
}

TEST_CASE("the sign of a form is exact where binary64 is not") {
  const polygon::Rational third = polygon::Rational(1) / 3;
  const DirectionForm form({third, -third, 0});
  CHECK(form.sign({0.1, 0.1, 5}) == 0);
  CHECK(form.sign({std::nextafter(0.1, 1), 0.1, 5}) == 1);
  CHECK(form.sign({std::nextafter(0.1, 0), 0.1, 5}) == -1);
  double error = 0;
  CHECK(form.value({3, 0, 0}, error) == 1);
  CHECK(error < 1e-15);
}
