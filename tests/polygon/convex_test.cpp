#include "durero/polygon/convex.hpp"

#include "shapes.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero::polygon;
using namespace durero::test;

namespace {

RationalPoint sum_of_areas(const std::vector<Polygon>& polygons) {
  RationalPoint sum{};
  for (const Polygon& one : polygons) sum = sum + doubled_area(one);
  return sum;
}

/// The inside of an upright square around the middle (x, y).
std::vector<PlaneSide> column(const Rational& x, const Rational& y, const Rational& half) {
  return {{{1, 0, 0}, x - half}, {{-1, 0, 0}, -x - half}, {{0, 1, 0}, y - half}, {{0, -1, 0}, -y - half}};
}

}  // namespace

TEST_CASE("a plane splits a square into two parts with its whole area, and touches without splitting") {
  const Polygon square = square_at(0, 0, 1);
  const PolygonParts cut = split(square, {{1, 0, 0}, Rational(1, 2)});
  CHECK(doubled_area(cut.inside) == RationalPoint{0, 0, 2});
  CHECK(doubled_area(cut.outside) == RationalPoint{0, 0, 6});
  CHECK(split(square, {{1, 0, 0}, 1}).inside.empty());
  CHECK(split(square, {{1, 0, 0}, 1}).outside == square);
  CHECK(split(square, {{1, 0, 0}, -1}).inside == square);
  CHECK(split(square, {{1, 0, 0}, -1}).outside.empty());
  const PolygonParts corners = split(square, {{1, 1, 0}, 0});  // through two corners
  CHECK(corners.inside.size() == 3);
  CHECK(corners.outside.size() == 3);
  CHECK(split({}, {{1, 0, 0}, 0}).outside.empty());
}

TEST_CASE("a body taken from a polygon leaves parts around it, and nothing where it takes all") {
  const Polygon square = square_at(0, 0, 3);
  const auto hole = column(0, 0, 1);
  CHECK(doubled_area(clipped(square, hole)) == RationalPoint{0, 0, 8});
  const auto around = without(square, hole);
  CHECK(around.size() == 4);
  CHECK(sum_of_areas(around) == RationalPoint{0, 0, 72 - 8});
  CHECK(without(square, column(9, 0, 1)) == std::vector<Polygon>{square});
  CHECK(without(square, column(4, 0, 1)) == std::vector<Polygon>{square});  // along an edge
  CHECK(without(square, column(0, 0, 3)).empty());
}

TEST_CASE("contains: edges and corners are of a polygon, whichever way around it goes") {
  Polygon square = square_at(0, 0, 1);
  for (int turn = 0; turn < 2; ++turn) {
    CHECK(contains(square, {0, 0, 0}));
    CHECK(contains(square, {1, 1, 0}));
    CHECK(contains(square, {1, Rational(1, 3), 0}));
    CHECK_FALSE(contains(square, {Rational(1000000001, 1000000000), 0, 0}));
    std::reverse(square.begin(), square.end());
  }
  CHECK_FALSE(contains({}, {0, 0, 0}));
}

TEST_CASE("what a plane cuts off and what it leaves have the whole area, and each its side") {
  property("of triangles in space", [] {
    const Polygon triangle = *any_triangle();
    const PlaneSide half{*any_corner(), *rc::gen::inRange(-9, 10)};
    RC_PRE(half.normal != RationalPoint{});
    const PolygonParts cut = split(triangle, half);
    RC_ASSERT(doubled_area(cut.inside) + doubled_area(cut.outside) == doubled_area(triangle));
    for (const RationalPoint& corner : cut.inside) RC_ASSERT(half.depth(corner) >= 0);
    for (const RationalPoint& corner : cut.outside) RC_ASSERT(half.depth(corner) <= 0);
  });
  property("of three planes in a row, in any order", [] {
    const Polygon triangle = *any_triangle();
    std::vector<PlaneSide> body;
    for (int i = 0; i < 3; ++i) {
      body.push_back({*any_corner(), *rc::gen::inRange(-9, 10)});
      RC_PRE(body.back().normal != RationalPoint{});
    }
    const RationalPoint kept = doubled_area(clipped(triangle, body));
    RC_ASSERT(kept + sum_of_areas(without(triangle, body)) == doubled_area(triangle));
    std::reverse(body.begin(), body.end());
    RC_ASSERT(doubled_area(clipped(triangle, body)) == kept);
  });
}
