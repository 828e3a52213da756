#include "durero/composed/form.hpp"

#include "durero/number/surd.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"
#include "support/shapes.hpp"

using namespace durero;
using composed::LinearForm;
using composed::QuadraticForm;
using composed::Rational;
using number::Dyadic;

namespace {

Rational part(std::int64_t n, std::int64_t d) { return Rational(n) / Rational(d); }

Rational value(const LinearForm& f, const Rational& x, const Rational& y, const Rational& z) {
  return f.x * x + f.y * y + f.z * z + f.one;
}

/// The polynomial along a ray at a whole parameter.
Rational value(const surface::Quadratic<Dyadic>& q, int t) {
  return q.A.rational() * t * t + 2 * q.B.rational() * t + q.C.rational();
}

const LinearForm f{part(1, 3), -2, 0, part(5, 7)}, g{0, 1, part(-1, 2), 4};
const model::Rayo rayo = test::ray({1, 0.5, -2}, {3, -1, 0.25});

}  // namespace

TEST_CASE("A form along a ray has the values of the polynomial at its points, times a positive number") {
  const QuadraticForm product = square(f) - QuadraticForm(g) * part(3, 5) + square(g) - Rational(2);
  const auto along = whole(product).along(rayo);
  Rational scale = 0;
  for (int t = -3; t <= 3; ++t) {
    const Rational x = 1 + Rational(3) * t, y = part(1, 2) - t, z = part(t, 4) - 2;
    const Rational a = value(f, x, y, z), b = value(g, x, y, z);
    const Rational there = a * a - b * part(3, 5) + b * b - 2;
    REQUIRE(there != 0);
    if (scale == 0) scale = value(along, t) / there;
    CHECK(value(along, t) == there * scale);
  }
  CHECK(scale > 0);
}

TEST_CASE("A form known to some digits holds the exact one along a ray") {
  const auto exact = whole(square(f) - QuadraticForm(g));
  const auto along = exact.along(rayo);
  const auto rough = roughly(exact).along(rayo);
  const auto holds = [](const number::RealBall& ball, const Dyadic& value) {
    const double unit = std::ldexp(1.0, static_cast<int>(ball.exponent));
    const double middle = number::round_to_binary64(value - Dyadic(ball.middle * unit));
    return std::abs(middle) <= ball.radius * unit * (1 + 1e-15);
  };
  CHECK(holds(rough.A, along.A));
  CHECK(holds(rough.B, along.B));
  CHECK(holds(rough.C, along.C));
}

TEST_CASE("The sign of a polynomial at a parameter is that of its exact value there") {
  test::property("for any coefficients and any number x + y√δ over w", [] {
    const auto any = [] { return *rc::gen::inRange(-6, 7); };
    const int w = *rc::gen::element(-3, -1, 1, 2);
    const number::DyadicSurd t{any(), any(), *rc::gen::inRange(0, 8), w};
    const surface::Quadratic<Dyadic> q{any(), any(), any()};
    const number::Surd s(t), A(q.A.rational()), B(q.B.rational()), C(q.C.rational());
    RC_ASSERT(composed::sign_at(q, t) == number::sign(A * s * s + number::Surd(2) * B * s + C));
  });
  // At the root √2 of t² − 2 exactly.
  CHECK(composed::sign_at({1, 0, -2}, {0, 1, 2}) == 0);
}
