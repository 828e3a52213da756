#include "io/mesh/turn.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "durero/number/rational.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;
using number::exact;
using number::Rational;

namespace {

Rational turn_by_rationals(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (exact(b.x) - exact(a.x)) * (exact(c.y) - exact(a.y)) - (exact(b.y) - exact(a.y)) * (exact(c.x) - exact(a.x));
}

// The determinant of (x, y, x² + y², 1) over the four points.
Rational circle_by_rationals(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  const auto lifted = [](const glm::dvec2& p) -> Rational { return exact(p.x) * exact(p.x) + exact(p.y) * exact(p.y); };
  return lifted(a) * turn_by_rationals(b, c, d) - lifted(b) * turn_by_rationals(a, c, d) +
         lifted(c) * turn_by_rationals(a, b, d) - lifted(d) * turn_by_rationals(a, b, c);
}

// Near a small grid, near enough for sums to round, with exponents up to the ends of binary64.
glm::dvec2 point_near_grid() {
  const auto below = [](int end) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, end)); };
  const auto coordinate = [&] {
    double x = below(5) - 2;
    for (int steps = std::max(below(6) - 3, 0); steps-- > 0;)
      x = std::nextafter(x, below(2) == 0 ? -HUGE_VAL : HUGE_VAL);
    return x;
  };
  const double u = coordinate(), v = coordinate();
  return {u, v};
}

}  // namespace

TEST_CASE("A turn goes left, right or nowhere") {
  CHECK(io::turn({0, 0}, {1, 0}, {5, 1}) == 1);
  CHECK(io::turn({0, 0}, {1, 0}, {5, -1}) == -1);
  CHECK(io::turn({0, 0}, {1, 1}, {3, 3}) == 0);
  CHECK(io::turn({0.1, 0.1}, {0.2, 0.2}, {0.3, std::nextafter(0.3, 1)}) == 1);
  const double most = std::numeric_limits<double>::max(), least = 5e-324;
  CHECK(io::turn({-most, -most}, {most, most}, {0, least}) == 1);
  CHECK(io::turn({-most, -most}, {most, most}, {least, least}) == 0);
  CHECK(io::turn({0, 0}, {least, 0}, {0, least}) == 1);
}

TEST_CASE("A point is inside a circle, on it or outside") {
  CHECK(io::circle_side({0, 0}, {1, 0}, {1, 1}, {0, 1}) == 0);
  CHECK(io::circle_side({0, 0}, {1, 0}, {1, 1}, {0, std::nextafter(1.0, 0)}) == 1);
  CHECK(io::circle_side({0, 0}, {1, 0}, {1, 1}, {0, std::nextafter(1.0, 2)}) == -1);
  const double most = std::numeric_limits<double>::max(), least = 5e-324;
  CHECK(io::circle_side({-most, -most}, {most, -most}, {most, most}, {-most, most}) == 0);
  CHECK(io::circle_side({-most, -most}, {most, -most}, {most, most}, {least, -least}) == 1);
  CHECK(io::circle_side({0, 0}, {least, 0}, {least, least}, {0, least}) == 0);
  CHECK(io::circle_side({0, 0}, {least, 0}, {least, least}, {0, 2 * least}) == -1);
}

TEST_CASE("Turns and circles are those of rational numbers") {
  std::size_t on_line = 0, on_circle = 0;
  test::property("points of a grid and beside it", [&] {
    const int exponent = *rc::gen::element(0, 0, -1060, 1000);
    const auto scaled = [&] {
      const glm::dvec2 p = point_near_grid();
      return glm::dvec2(std::ldexp(p.x, exponent), std::ldexp(p.y, exponent));
    };
    for (int tries = 0; tries < 20; ++tries) {
      const glm::dvec2 a = scaled(), b = scaled(), c = scaled(), d = scaled();
      const int turn = sign(turn_by_rationals(a, b, c)), side = sign(circle_by_rationals(a, b, c, d));
      RC_ASSERT(io::turn(a, b, c) == turn);
      RC_ASSERT(io::circle_side(a, b, c, d) == side);
      on_line += turn == 0 ? 1 : 0;
      on_circle += turn != 0 && side == 0 ? 1 : 0;
    }
  });
  if (!test::sanitized) CHECK((on_line > 0 && on_circle > 0));
}
