#include "durero/algebra/root.hpp"

#include "durero/number/rational.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

namespace durero::algebra {
namespace {

using number::Dyadic;
using number::DyadicSurd;
using number::Rational;

/// The product of the factors d·t − n of rational numbers n/d, times a leading factor.
Polynomial with_roots(const std::vector<Rational>& roots, Dyadic leading = 1) {
  Polynomial p{std::move(leading)};
  for (const Rational& root : roots) {
    const Dyadic n(numerator(root), 0), d(denominator(root), 0);
    Polynomial q(p.size() + 1);
    for (std::size_t i = 0; i < p.size(); ++i) {
      q[i] -= p[i] * n;
      q[i + 1] += p[i] * d;
    }
    p = q;
  }
  return p;
}

std::vector<double> rounded(const std::vector<Root>& roots) {
  std::vector<double> values;
  for (const Root& root : roots) values.push_back(rounded_linear(0, 1, root));
  return values;
}

/// A fraction in tenths or so, that repeats often.
rc::Gen<Rational> fraction() {
  return rc::gen::map(
      rc::gen::pair(rc::gen::resize(100, rc::gen::inRange(-30, 60)), rc::gen::resize(100, rc::gen::inRange(1, 12))),
      [](const auto& pair) { return Rational(pair.first, pair.second); });
}

TEST_CASE("A polynomial has the positive roots that it was made of, each once, and they are rounded once") {
  test::property("products of linear factors", [] {
    const auto roots = *rc::gen::resize(8, rc::gen::container<std::vector<Rational>>(fraction()));
    std::set<Rational> positive;
    for (const Rational& root : roots)
      if (root > 0) positive.insert(root);
    std::vector<double> expected;
    for (const Rational& root : positive) expected.push_back(number::round_to_binary64(root));
    RC_ASSERT(rounded(positive_roots(with_roots(roots, -3))) == expected);
  });
}

TEST_CASE("A linear function of the cube root of two lies between the numbers that round to its rounding") {
  const auto roots = positive_roots({-2, 0, 0, 1});
  REQUIRE(roots.size() == 1);
  for (const auto& [m, n] : {std::pair{0, 1}, std::pair{-3, 2}, std::pair{1, -1}, std::pair{7, -5}}) {
    const double value = rounded_linear(m, n, roots[0]);
    const auto cube = [&, from = m, times = n](const Rational& x) {
      const Rational t = (x - from) / times;
      return Rational(t * t * t);
    };
    const Rational up = (number::exact(value) + number::exact(std::nextafter(value, 9.0))) / 2;
    const Rational down = (number::exact(value) + number::exact(std::nextafter(value, -9.0))) / 2;
    CHECK((n > 0 ? cube(down) : cube(up)) < 2);
    CHECK((n > 0 ? cube(up) : cube(down)) > 2);
  }
}

TEST_CASE("Roots that lie very near to each other are told apart, and a tie is none of them") {
  // (t³ − 2)·(t³ − 2 − 2⁻⁴⁰⁰): the roots are less than 2⁻⁴⁰⁰ apart.
  const Dyadic small = number::shifted(Dyadic(1), -400), other = Dyadic(2) + small;
  const auto near = positive_roots({Dyadic(2) * other, 0, 0, -Dyadic(2) - other, 0, 0, 1});
  REQUIRE(near.size() == 2);
  const auto one = positive_roots({-2, 0, 0, 1}), two = positive_roots({-other, 0, 0, 1});
  CHECK((compare(near[0], one[0]) == 0));
  CHECK((compare(near[1], two[0]) == 0));
  CHECK((compare(near[0], near[1]) < 0));
  CHECK((compare(two[0], one[0]) > 0));
  CHECK(sign_at(Polynomial{-2, 0, 0, 1}, near[0]) == 0);
  CHECK(sign_at(Polynomial{-2, 0, 0, 1}, near[1]) == 1);
  CHECK((compare(DyadicSurd{between(near[0], near[1])}, near[0]) > 0));
  CHECK((compare(DyadicSurd{between(near[0], near[1])}, near[1]) < 0));
}

TEST_CASE("A root of degree four that is one of degree two is found equal to it") {
  // (t² − 2)·(t² + t + 1), and √2 as the house has it.
  const auto roots = positive_roots({-2, -2, -1, 1, 1});
  REQUIRE(roots.size() == 1);
  CHECK(std::holds_alternative<Isolated>(roots[0]));
  CHECK((compare(roots[0], DyadicSurd{0, 1, 2, 1}) == 0));
  CHECK((compare(DyadicSurd{0, -1, 2, -1}, roots[0]) == 0));
  CHECK((compare(roots[0], DyadicSurd{0, 1, 3, 1}) < 0));
  CHECK((compare(DyadicSurd{0, 1, 3, 1}, roots[0]) > 0));
  CHECK(sign_at(Polynomial{-2, 0, 1}, roots[0]) == 0);
  CHECK(sign_at(Polynomial{-2, 0, 0, 1}, roots[0]) == 1);
  CHECK(sign_at(Polynomial{-3, 0, 1}, roots[0]) == -1);
}

TEST_CASE("A sign at a root of degree two is that of the polynomial there, whatever the sign of its denominator") {
  const DyadicSurd root{0, -1, 2, -1};  // √2
  CHECK(sign_at(Polynomial{0, -2, 0, 1}, root) == 0);
  CHECK(sign_at(Polynomial{0, 0, 0, 1}, root) == 1);
  CHECK(sign_at(Polynomial{-3, 0, 0, 1}, root) == -1);
  CHECK(sign_at(Polynomial{1, -1}, root) == -1);
}

TEST_CASE("A value half-way between two numbers goes to the even one, and a sum that is zero is zero") {
  // t = 1/3 of degree three: m + n·t with n = 3 is exact.
  const auto third = positive_roots(with_roots({Rational(1, 3)}, 1));
  const auto cubic = positive_roots({-1, 3, -1, 3});  // (3t − 1)(t² + 1)
  REQUIRE(cubic.size() == 1);
  CHECK((compare(cubic[0], third[0]) == 0));
  const double after = std::nextafter(1.0, 2.0);
  const Dyadic half_gap = number::shifted(Dyadic(1), -53);
  CHECK(rounded_linear(1, half_gap * Dyadic(3), cubic[0]) == 1);
  CHECK(rounded_linear(after, half_gap * Dyadic(3), cubic[0]) == std::nextafter(after, 2.0));
  CHECK(rounded_linear(Dyadic(1) + number::shifted(Dyadic(1), -200), half_gap * Dyadic(3), cubic[0]) == after);
  CHECK(rounded_linear(after, -(half_gap * Dyadic(3)), cubic[0]) == 1);
  CHECK(rounded_linear(1, -3, cubic[0]) == 0);
  CHECK_FALSE(std::signbit(rounded_linear(-1, 3, cubic[0])));
  CHECK(rounded_linear(-1, 3, cubic[0]) == 0);
  const Dyadic tiny = number::shifted(Dyadic(1), -2000), huge = number::shifted(Dyadic(1), 1024);
  CHECK(std::signbit(rounded_linear(0, -tiny, cubic[0])));
  CHECK(rounded_linear(0, huge * Dyadic(4), cubic[0]) == std::numeric_limits<double>::infinity());
}

TEST_CASE("There is a number below a root, above it and between two") {
  const auto roots = positive_roots(with_roots({Rational(1, 1000), Rational(7, 3), Rational(1000)}));
  REQUIRE(roots.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK((compare(DyadicSurd{below(roots[i])}, roots[i]) < 0));
    CHECK(number::sign(below(roots[i])) > 0);
    CHECK((compare(DyadicSurd{above(roots[i])}, roots[i]) > 0));
  }
  const Dyadic middle = between(roots[0], roots[1]);
  CHECK((compare(DyadicSurd{middle}, roots[0]) > 0));
  CHECK((compare(DyadicSurd{middle}, roots[1]) < 0));
}

TEST_CASE("Roots at zero are none, and neither are those below it") {
  CHECK(positive_roots({0, 0, 0, 1}).empty());
  CHECK(positive_roots({0, 0, 0, 1, 1}).empty());
  CHECK(positive_roots({5}).empty());
  CHECK(positive_roots({0, 1}).empty());
  CHECK(positive_roots({1, 0, 1}).empty());
  CHECK(rounded(positive_roots({0, 0, -1, 0, 1})) == std::vector<double>{1});
  CHECK(rounded(positive_roots({0, -1, 1})) == std::vector<double>{1});
  CHECK(rounded(positive_roots({2, -3, 1})) == std::vector<double>{1, 2});
  CHECK(rounded(positive_roots({-2, 3, -1})) == std::vector<double>{1, 2});
}

}  // namespace
}  // namespace durero::algebra
