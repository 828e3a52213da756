#include "durero/polygon/pyramid.hpp"

#include <algorithm>

#include "shapes.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero::polygon;
using namespace durero::test;

namespace {

const PlaneSide floor_plane{{0, 0, 1}, 0};

bool is_in(const std::vector<PlaneSide>& body, const RationalPoint& w) {
  return !body.empty() && std::ranges::all_of(body, [&](const PlaneSide& half) { return half.depth(w) >= 0; });
}

}  // namespace

TEST_CASE("the shadow of a square on a plane is (h/(h − d))² as large, and that of a far light as large") {
  const Polygon square = square_at(1, 2, 1, 3);
  const Polygon floor = square_at(0, 0, 100);
  const Apex lamp{{0, 0, 5}};
  CHECK(doubled_area(clipped(floor, hidden(lamp, square))) == RationalPoint{0, 0, Rational(8 * 25, 4)});
  const Apex sun{{1, 1, 4}, true};
  CHECK(doubled_area(clipped(floor, hidden(sun, square))) == RationalPoint{0, 0, 8});
}

TEST_CASE("a polygon hides nothing before it, nothing behind the apex, and nothing edge-on") {
  const Polygon square = square_at(0, 0, 1, 3);
  const Apex lamp{{0, 0, 5}};
  const auto body = hidden(lamp, square);
  CHECK(is_in(body, {0, 0, 0}));
  CHECK(is_in(body, {1, 1, 3}));
  CHECK_FALSE(is_in(body, {0, 0, 4}));
  CHECK_FALSE(is_in(body, {0, 0, 6}));
  CHECK(is_in(pyramid(lamp, square), {0, 0, 4}));
  CHECK_FALSE(is_in(pyramid(lamp, square), {0, 0, 6}));
  CHECK(hidden({{7, 0, 3}}, square).empty());
  CHECK(hidden({{7, 1, 0}, true}, square).empty());
  CHECK_FALSE(side_of({{7, 0, 3}}, square));
  CHECK(side_of({{0, 0, -1}, true}, square)->depth({0, 0, 2}) > 0);
}

TEST_CASE("projected: on the ray from the apex through the point, and nowhere else") {
  const Apex lamp{{0, 0, 5}};
  CHECK(projected(lamp, {1, 1, 3}, floor_plane) == RationalPoint{Rational(5, 2), Rational(5, 2), 0});
  CHECK(projected(lamp, {1, 1, -5}, floor_plane) == RationalPoint{Rational(1, 2), Rational(1, 2), 0});
  CHECK_FALSE(projected(lamp, {1, 1, 6}, floor_plane));
  CHECK_FALSE(projected(lamp, {1, 1, 5}, floor_plane));
  CHECK(projected({{1, 0, 1}, true}, {1, 1, -1}, floor_plane) == RationalPoint{2, 1, 0});
  CHECK_FALSE(projected({{1, 0, 0}, true}, {1, 1, 3}, floor_plane));
}

TEST_CASE("the projected corners of a polygon are those of what it hides on a plane") {
  property("from before all of it", [] {
    Polygon triangle = *any_triangle();
    for (RationalPoint& corner : triangle) corner.z = corner.z + 10;
    RC_PRE(doubled_area(triangle) != RationalPoint{});
    const Apex lamp{{*rc::gen::inRange(-9, 10), *rc::gen::inRange(-9, 10), 20}};
    RC_PRE(side_of(lamp, triangle).has_value());
    const Polygon seen = clipped(square_at(0, 0, 1000), hidden(lamp, triangle));
    Polygon corners;
    for (const RationalPoint& corner : triangle) corners.push_back(projected(lamp, corner, floor_plane).value());
    RC_ASSERT(seen.size() == 3u);
    for (const RationalPoint& corner : corners) RC_ASSERT(std::ranges::count(seen, corner) == 1);
  });
}
