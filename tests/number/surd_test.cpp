#include "durero/number/surd.hpp"

#include "support/catch.hpp"
#include "support/nearest.hpp"
#include "surds.hpp"

namespace durero::number {
namespace {

using test::anyFinite;
using test::anySurd;

rc::Gen<Rational> ratio(const rc::Gen<double>& number) {
  return rc::gen::apply([](double n, double d) { return Rational(exact(n) / exact(d)); }, number,
                        test::nonZero(number));
}

/// A small number of fields, so that operands often share one.
rc::Gen<Surd> surdIn(const Rational& delta) {
  const auto number = ratio(test::dyadicGrid());
  return rc::gen::apply([delta](const Rational& x, const Rational& y, int k) { return Surd(x, y, delta * k * k); },
                        number, number, rc::gen::resize(100, rc::gen::inRange(1, 4)));
}

rc::Gen<Rational> radicand() {
  return rc::gen::map(rc::gen::resize(100, rc::gen::inRange(0, 40)), [](int n) { return Rational(n, 3); });
}

TEST_CASE("A surd whose value is rational by sight is that rational") {
  const Surd square(1, 3, Rational(4, 9));
  CHECK(square.x == 3);
  CHECK(square.y == 0);
  CHECK(square.delta == 0);
  CHECK(Surd(1, 0, 2).delta == 0);
  CHECK(Surd(0.5).x == Rational(1, 2));
  CHECK(Surd(0, 1, 2).y == 1);
  CHECK_THROWS_AS(Surd(1, 1, -1), std::domain_error);
  CHECK_THROWS_AS(Surd(std::numeric_limits<double>::quiet_NaN()), std::domain_error);
}

TEST_CASE("Surds of one quadratic field are a field") {
  test::property("its laws hold exactly", [] {
    const Rational delta = *radicand();
    const Surd a = *surdIn(delta), b = *surdIn(delta), c = *surdIn(delta);
    RC_ASSERT(a + b == b + a);
    RC_ASSERT(a * b == b * a);
    RC_ASSERT((a + b) + c == a + (b + c));
    RC_ASSERT((a * b) * c == a * (b * c));
    RC_ASSERT(a * (b + c) == a * b + a * c);
    RC_ASSERT(a - a == Surd());
    RC_ASSERT(sign(a * b) == sign(a) * sign(b));
    RC_PRE(sign(b) != 0);
    RC_ASSERT(a / b * b == a);
  });
  test::property("(x + y√δ)(x − y√δ) = x² − y²δ", [] {
    const Rational x = *ratio(anyFinite()), y = *ratio(anyFinite()), delta = abs(*ratio(anyFinite()));
    RC_ASSERT(Surd(x, y, delta) * Surd(x, -y, delta) == Surd(Rational(x * x - y * y * delta)));
  });
}

TEST_CASE("Arithmetic between different fields and division by 0 are refused") {
  const Surd root2(0, 1, 2), root3(0, 1, 3);
  CHECK_THROWS_AS(root2 + root3, std::domain_error);
  CHECK_THROWS_AS(root2 - root3, std::domain_error);
  CHECK_THROWS_AS(root2 * root3, std::domain_error);
  CHECK_THROWS_AS(root2 / root3, std::domain_error);
  CHECK_THROWS_AS(root2 / Surd(), std::domain_error);
  CHECK_THROWS_AS(root2 / (root2 - root2), std::domain_error);
  CHECK(root2 * Surd(0, 1, 8) == Surd(4));
  CHECK(root2 + Surd(0, 1, 8) == Surd(0, 3, 2));
  CHECK(Surd(1) / root2 == Surd(0, Rational(1, 2), 2));
}

TEST_CASE("The roots of A·t² + 2B·t + C, substituted back, give exactly 0") {
  const auto check = [](const rc::Gen<double>& number) {
    const Dyadic a = *test::nonZero(number), b = *number, c = *number;
    const Dyadic delta = b * b - a * c;
    RC_PRE(sign(delta) >= 0);
    const Surd A(a.rational()), B(b.rational()), C(c.rational());
    const Surd one(DyadicSurd{.x = -b, .y = -1, .delta = delta, .w = a});
    const Surd other(DyadicSurd{.x = -b, .y = 1, .delta = delta, .w = a});
    for (const Surd& root : {one, other}) RC_ASSERT(sign(A * root * root + Surd(2) * B * root + C) == 0);
    RC_ASSERT(one * other == C / A);
    RC_ASSERT(one + other == Surd(-2) * B / A);
    RC_ASSERT((one < other) == (sign(delta) > 0 && sign(a) > 0));
  };
  test::property("full range", [&] { check(anyFinite()); });
  test::property("grid", [&] { check(test::dyadicGrid()); });
}

TEST_CASE("The two forms of a surd are the same number") {
  test::property("sign, order and rounding", [] {
    const DyadicSurd a = (*anySurd()).surd(), b = (*anySurd()).surd();
    RC_ASSERT(sign(Surd(a)) == sign(a));
    RC_ASSERT((compare(Surd(a), Surd(b)) == compare(a, b)));
    RC_ASSERT(round_to_binary64(Surd(a)) == round_to_binary64(a));
    RC_ASSERT((Surd(a) - Surd(a.x.rational() / a.w.rational())) == Surd(DyadicSurd{0, a.y, a.delta, a.w}));
  });
  CHECK_THROWS_AS(Surd(DyadicSurd{1, 1, 2, 0}), std::domain_error);
}

TEST_CASE("sign_of_sum over the rationals") {
  const Rational third(1, 3);
  CHECK(sign_of_sum(Rational(-1), third, Rational(9), Rational(0), Rational(5)) == 0);
  CHECK(sign_of_sum(Rational(0), Rational(1), third, Rational(-1, 3), Rational(3)) == 0);  // √(1/3) = √3/3
  CHECK(sign_of_sum(Rational(-3), Rational(1), Rational(2), Rational(1), Rational(3)) == 1);
  CHECK(sign_of_sum(Rational(3), Rational(-1), Rational(2), Rational(-1), Rational(3)) == -1);
  CHECK_THROWS_AS(sign_of_sum(Rational(0), Rational(1), Rational(-1), Rational(1), Rational(1)), std::domain_error);
  CHECK_THROWS_AS(sign_of_sum(Rational(0), Rational(1), Rational(1), Rational(1), Rational(-1)), std::domain_error);
}

TEST_CASE("A surd over the rationals is rounded once") {
  CHECK(round_to_binary64(Surd(0, 1, 2)) == 0x1.6a09e667f3bcdp0);
  CHECK(round_to_binary64(Surd(Rational(1, 2), Rational(1, 2), 5)) == 0x1.9e3779b97f4a8p0);
  test::property("to the nearest, ties to even", [] {
    const Surd value(*ratio(anyFinite()), *ratio(test::moderate()), abs(*ratio(anyFinite())));
    RC_ASSERT(test::is_nearest(round_to_binary64(value), [&](const Rational& m) { return compare(value, Surd(m)); }));
  });
}

}  // namespace
}  // namespace durero::number
