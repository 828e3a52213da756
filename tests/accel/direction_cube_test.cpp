#include "durero/accel/direction_cube.hpp"

#include <cmath>

#include "durero/conform/random.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

using namespace durero;
using namespace durero::test;
using accel::CubePoint;
using accel::Square;

namespace {

bool holds(const Square& square, const CubePoint& place) {
  const auto between = [&](double least, double x) {
    return least <= x && (x < least + square.side || (x == 1 && least + square.side == 1));
  };
  return square.face == place.face && between(square.u, place.u) && between(square.v, place.v);
}

/// Of a random direction: each third time on an edge, a corner, or the border of squares.
glm::dvec3 random_direction(conform::Random& random, int number) {
  const double length = random.uniform(0.1, 10);
  if (number % 3 != 0) return random.direction() * length;
  return random.lattice_vector(4);
}

}  // namespace

/// Of so many directions: each lies in one quarter of the square that it lies in.
static void check_quarters(int directions) {
  conform::Random random(1);
  for (int i = 0; i < directions; ++i) {
    const CubePoint place = accel::place_of(random_direction(random, i));
    Square square = accel::whole(place.face);
    for (int depth = 0; depth < 12; ++depth) {
      const std::uint32_t chosen = accel::quarter_of(square, place);
      int holding = 0;
      for (std::uint32_t which = 0; which < 4; ++which) holding += holds(accel::quarter(square, which), place);
      square = accel::quarter(square, chosen);
      if (holding != 1 || !holds(square, place)) FAIL(i << ": " << holding << " quarters");
    }
  }
}

TEST_CASE("every direction lies in exactly one quarter of the square that it lies in, at any depth") {
  check_quarters(static_cast<int>(fewer_when_sanitized(20'000)));
}
TEST_CASE("each of ten million directions lies in exactly one square, at any depth", "[long]") {
  check_quarters(10'000'000);
}

TEST_CASE("faces are those of the greatest component, the first of equal ones") {
  CHECK(accel::place_of({2, 1, -1}) == CubePoint{0, 0.5, -0.5});
  CHECK(accel::place_of({-2, 1, -1}) == CubePoint{1, 0.5, -0.5});
  CHECK(accel::place_of({1, 2, -1}) == CubePoint{2, -0.5, 0.5});
  CHECK(accel::place_of({1, -2, -1}) == CubePoint{3, -0.5, 0.5});
  CHECK(accel::place_of({1, -1, 2}) == CubePoint{4, 0.5, -0.5});
  CHECK(accel::place_of({1, -1, -2}) == CubePoint{5, 0.5, -0.5});
  CHECK(accel::place_of({-3, 3, -3}) == CubePoint{1, 1, -1});
  CHECK(accel::place_of({0, 3, -3}) == CubePoint{2, -1, 0});
}

TEST_CASE("a dyadic place is the place of its direction") {
  for (std::uint32_t face = 0; face < 6; ++face)
    for (double u = -1 + 0x1p-4; u < 1; u += 0x1p-4)
      for (double v = -1 + 0x1p-4; v < 1; v += 0x1p-4) {
        const CubePoint place{face, u, v};
        CHECK(accel::place_of(accel::direction_of(place)) == place);
        CHECK(accel::place_of(accel::direction_of(place) * 0x1.8p7) == place);
      }
}

TEST_CASE("the cone of a square holds its directions, and little more") {
  conform::Random random(2);
  for (int i = 0; i < static_cast<int>(fewer_when_sanitized(20'000)); ++i) {
    const glm::dvec3 direction = random_direction(random, i);
    Square square = accel::whole(accel::place_of(direction).face);
    for (int depth = 0; depth < 9; ++depth) {
      const accel::DirectionCone cone = accel::cone_of(square, 0);
      const double at = accel::cosine_between(cone.axis, accel::direction(direction));
      if (!(at >= cone.cosine)) FAIL(i << " at depth " << depth);
      if (depth > 0 && !(std::acos(cone.cosine) < 1.5 * square.side)) FAIL("the cone is wide at depth " << depth);
      const accel::DirectionCone wider = accel::cone_of(square, 0x1p-10);
      if (!(std::acos(wider.cosine) - std::acos(cone.cosine) > 0x1.fp-11)) FAIL("no wider at depth " << depth);
      square = accel::quarter(square, accel::quarter_of(square, accel::place_of(direction)));
    }
  }
}
