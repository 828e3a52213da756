#include "durero/number/ball.hpp"

#include "support/catch.hpp"
#include "support/doubles.hpp"
#include "support/property.hpp"

namespace durero::number {
namespace {

/// |v − middle · 2^exponent| ≤ radius · 2^exponent, in exact arithmetic.
bool contains(const RealBall& ball, const Rational& v) {
  const Rational unit = shifted(Dyadic(1), ball.exponent).rational();
  return abs(Rational(v - exact(ball.middle) * unit)) <= exact(ball.radius) * unit;
}

/// Products of two full-range doubles: more bits than a ball holds.
rc::Gen<Dyadic> operand() {
  const auto number = rc::gen::oneOf(test::anyFinite(), test::moderate(), test::dyadicGrid());
  return rc::gen::apply([](double a, double b) { return Dyadic(a) * Dyadic(b); }, number, number);
}

TEST_CASE("A ball holds the number that it stands for") {
  test::property("after each operation, and after several", [] {
    const Dyadic a = *operand(), b = *operand(), c = *operand();
    const Rational p = a.rational(), q = b.rational(), r = c.rational();
    RC_ASSERT(contains(RealBall(a), p));
    RC_ASSERT(contains(RealBall(a) - RealBall(b), p - q));
    RC_ASSERT(contains(-RealBall(a), -p));
    RC_ASSERT(contains(RealBall(a) + RealBall(b), p + q));
    RC_ASSERT(contains(RealBall(a) * RealBall(b), p * q));
    RC_ASSERT(contains((RealBall(a) * RealBall(b) + RealBall(c)) * RealBall(a) + -RealBall(b), (p * q + r) * p - q));
    RC_PRE(sign(c) != 0);
    RC_ASSERT(contains(RealBall(a) / RealBall(c), p / r));
    RC_ASSERT(contains((RealBall(a) + RealBall(b)) / RealBall(c), (p + q) / r));
  });
  test::property("and the root: its ends squared enclose the radicand", [] {
    const Dyadic a = *operand();
    const Dyadic size = sign(a) < 0 ? -a : a;
    const RealBall root = sqrt(RealBall(size));
    const Rational unit = shifted(Dyadic(1), root.exponent).rational();
    const Rational low = (exact(root.middle) - exact(root.radius)) * unit;
    const Rational high = (exact(root.middle) + exact(root.radius)) * unit;
    RC_ASSERT(low >= 0);
    RC_ASSERT(low * low <= size.rational());
    RC_ASSERT(size.rational() <= high * high);
  });
}

TEST_CASE("The ball of a binary64 is that number alone") {
  test::property("of any", [] {
    const double x = *test::anyFinite();
    const RealBall ball(x);
    RC_ASSERT(ball.radius == 0);
    RC_ASSERT(contains(ball, exact(x)));
    RC_ASSERT(sign(ball) == (x > 0) - (x < 0));
  });
}

TEST_CASE("The radius covers every pair of numbers of two balls") {
  const auto ball = [] {
    return *rc::gen::apply([](double m, double r, int e) { return RealBall(m, std::abs(r), e); }, test::moderate(),
                           rc::gen::oneOf(test::dyadicGrid(), rc::gen::just(0x1p-53), rc::gen::just(0.0)),
                           rc::gen::resize(100, rc::gen::element(-1000, -199, -3, 0, 2, 1000)));
  };
  const auto end = [](const RealBall& b, int side) {
    const Rational unit = shifted(Dyadic(1), b.exponent).rational();
    return Rational((exact(b.middle) + side * exact(b.radius)) * unit);
  };
  test::property("their ends", [&] {
    const RealBall a = ball(), b = ball();
    const Dyadic c = *test::nonZero(test::moderate());
    for (const int i : {-1, 1}) {
      RC_ASSERT(contains(RealBall(a) / RealBall(c), end(a, i) / c.rational()));
      for (const int j : {-1, 1}) {
        RC_ASSERT(contains(a + b, end(a, i) + end(b, j)));
        RC_ASSERT(contains(a * b, end(a, i) * end(b, j)));
        RC_ASSERT(contains(a / RealBall(c), end(a, i) / end(RealBall(c), j)));
      }
    }
  });
  test::property("and those of a root's", [&] {
    const RealBall square(std::abs(*test::nonZero(test::moderate())), 0x1p-10, *rc::gen::element(-3, 0, 1, 100));
    const RealBall root = sqrt(square);
    const Rational low = end(root, -1), high = end(root, 1);
    RC_ASSERT(low < 0 || low * low <= end(square, -1));
    RC_ASSERT(high * high >= end(square, 1));
  });
}

TEST_CASE("A ball decides a sign only where all of it has that sign, and nearly always where it is not close") {
  CHECK(RealBall(1.0, 0.5, 0).decided_sign() == 1);
  CHECK(RealBall(-1.0, 0.5, 0).decided_sign() == -1);
  CHECK(RealBall(0.5, 0.5, 0).decided_sign() == 0);
  CHECK(RealBall(-0.5, 0.5, 0).decided_sign() == 0);
  CHECK((RealBall(Dyadic(1)) + -RealBall(Dyadic(1))).decided_sign() == 0);
  test::property("a relative difference of 2⁻⁴⁰ is seen", [] {
    const Dyadic a = *test::nonZero(test::anyFinite());
    const Dyadic b = a + shifted(a, -40);
    RC_ASSERT((RealBall(b) + -RealBall(a)).decided_sign() == sign(a));
  });
}

}  // namespace
}  // namespace durero::number
