#include "durero/number/dyadic_surd.hpp"

#include <array>
#include <limits>

#include "durero/number/quotient.hpp"
#include "number/quick_round.hpp"
#include "support/catch.hpp"
#include "support/nearest.hpp"
#include "surds.hpp"

namespace durero::number {
namespace {

using test::anyFinite;
using test::anySurd;
using test::dyadicGrid;
using test::Real;
using test::sign_of;
using test::SurdParts;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double greatest = std::numeric_limits<double>::max();

/// sign_of_sum of these numbers, which also fit the one of rational numbers.
int sign(const Dyadic& x, const Dyadic& y, const Dyadic& a, const Dyadic& z, const Dyadic& b) {
  return sign_of_sum(x, y, a, z, b);
}

bool is_rounded(const DyadicSurd& value) {
  return test::is_nearest(round_to_binary64(value), [&](const Rational& m) {
    const Dyadic d(denominator(m), 0);
    return sign(DyadicSurd{value.x * d - value.w * Dyadic(numerator(m), 0), value.y * d, value.delta, value.w}) <=> 0;
  });
}

TEST_CASE("The sign of a surd agrees with 8000 bits") {
  test::property("over the whole range, and where x and y√delta cancel", [] {
    const SurdParts s = *anySurd();
    const int expected = sign_of(s.real(), s.size());
    RC_TAG(expected == 0                             ? "zero"
           : enclosure(s.surd()).decided_sign() != 0 ? "decided by the ball"
                                                     : "decided exactly");
    RC_ASSERT(sign(s.surd()) == expected);
  });
}

TEST_CASE("The order of surds of different radicands agrees with 8000 bits") {
  test::property("over the whole range", [] {
    const SurdParts a = *anySurd();
    const SurdParts b = *anySurd();
    const int expected = sign_of(a.real() - b.real(), a.size() + b.size());
    RC_ASSERT((compare(a.surd(), b.surd()) == (expected <=> 0)));
    RC_ASSERT((compare(b.surd(), a.surd()) == (0 <=> expected)));
  });
  test::property("where they differ in the last place of one binary64", [] {
    const SurdParts a = *anySurd();
    SurdParts b = a;
    double& part = b.*(*rc::gen::element(&SurdParts::x, &SurdParts::y, &SurdParts::delta, &SurdParts::w));
    part = std::nextafter(part, *rc::gen::element(-infinity, infinity));
    RC_PRE(std::isfinite(part) && b.w != 0 && b.delta >= 0);
    const int expected = sign_of(a.real() - b.real(), a.size() + b.size());
    RC_ASSERT((compare(a.surd(), b.surd()) == (expected <=> 0)));
  });
}

TEST_CASE("sign_of_sum agrees with 8000 bits") {
  test::property("x + y√a + z√b with x next to its opposite", [] {
    const auto number = *rc::gen::element(anyFinite(), test::moderate(), dyadicGrid());
    const double y = *number, a = std::abs(*number), z = *number, b = std::abs(*number);
    const double near = -(y * std::sqrt(a) + z * std::sqrt(b));
    const double x = std::isfinite(near) ? near : *number;
    const Real ya = Real(y) * sqrt(Real(a)), zb = Real(z) * sqrt(Real(b));
    RC_ASSERT(sign(x, y, a, z, b) == sign_of(Real(x) + ya + zb, abs(Real(x)) + abs(ya) + abs(zb)));
  });
  CHECK(sign(0, 3, 2, -1, 18) == 0);  // 3√2 = √18
  CHECK(sign(-5, 1, 4, 1, 9) == 0);   // √4 + √9 = 5
  CHECK(sign(-3, 1, 2, 1, 3) == 1);   // √2 + √3 = 3.146…
  CHECK(sign(0, 1, 0, 0, 7) == 0);
  CHECK(sign(-3, 1, 9, shifted(Dyadic(1), -300), 2) == 1);  // −3 + √9 + 2⁻³⁰⁰√2
  CHECK_THROWS_AS(sign(1, 1, -1, 1, 1), std::domain_error);
  CHECK_THROWS_AS(sign(1, 1, 1, 1, -1), std::domain_error);
}

TEST_CASE("What balls cannot decide is decided exactly") {
  // 3√2 = √18, moved by less than a ball can see.
  const DyadicSurd root{.y = 3, .delta = 2};
  const Dyadic nudge = shifted(Dyadic(1), -300);
  for (const int side : {-1, 0, 1}) {
    const DyadicSurd other{.x = nudge * Dyadic(side), .y = 1, .delta = 18};
    CHECK((enclosure(other) + -enclosure(root)).decided_sign() == 0);
    CHECK((compare(other, root) == (side <=> 0)));
    CHECK((compare(root, other) == (0 <=> side)));
  }
}

TEST_CASE("compare is a strict total order") {
  test::property("on a grid, where equal values of different form are frequent", [] {
    const auto surd = rc::gen::map(test::surdsOf(dyadicGrid()), [](const SurdParts& s) { return s; });
    std::array<DyadicSurd, 3> s{(*surd).surd(), (*surd).surd(), (*surd).surd()};
    std::sort(s.begin(), s.end());
    RC_ASSERT(s[0] <= s[1] && s[1] <= s[2] && s[0] <= s[2]);
    RC_ASSERT((s[0] == s[2]) == (s[0] == s[1] && s[1] == s[2]));
    RC_ASSERT((s[0] < s[1]) == !(s[1] <= s[0]));
    RC_ASSERT(s[0] == s[0] && !(s[0] < s[0]));
  });
  test::property("equal where numerator and denominator are scaled, or delta by a square", [] {
    const DyadicSurd s = (*anySurd()).surd();
    const Dyadic k = *test::nonZero(anyFinite());
    RC_ASSERT(s == (DyadicSurd{s.x * k, s.y * k, s.delta, s.w * k}));
    RC_ASSERT(s == (DyadicSurd{s.x * k, s.y * (sign(k) < 0 ? -1 : 1), s.delta * square(k), s.w * k}));
  });
}

TEST_CASE("linear is m + n·value") {
  test::property("to 8000 bits", [] {
    const double m = *anyFinite(), n = *anyFinite();
    const SurdParts s = *anySurd();
    RC_ASSERT(sign(linear(m, n, s.surd())) ==
              sign_of(Real(m) + Real(n) * s.real(), abs(Real(m)) + abs(Real(n)) * s.size()));
  });
  CHECK(linear(1, 2, {.x = 3, .y = 1, .delta = 5, .w = 2}) == (DyadicSurd{.x = 4, .y = 1, .delta = 5}));
}

TEST_CASE("A surd is rounded to the nearest binary64, ties to even") {
  test::property("over the whole range, and where x and y√delta cancel", [] {
    const DyadicSurd value = (*anySurd()).surd();
    RC_ASSERT(is_rounded(value));
  });
  test::property("√ as the machine computes it", [] {
    const double delta = std::abs(*anyFinite());
    RC_ASSERT(round_to_binary64(DyadicSurd{.y = 1, .delta = delta}) == std::sqrt(delta));
  });
  test::property("and monotone", [] {
    const DyadicSurd a = (*anySurd()).surd();
    const DyadicSurd b = (*anySurd()).surd();
    RC_ASSERT(round_to_binary64(std::min(a, b)) <= round_to_binary64(std::max(a, b)));
  });
}

/// The number middle + side·2^−4000 as x + √delta over w, where x and √delta are both far from it.
DyadicSurd beside(const Dyadic& middle, int side, const Dyadic& q, const Dyadic& w) {
  return {.x = middle * w - q, .y = 1, .delta = square(q) + shifted(Dyadic(side), -9000), .w = w};
}

TEST_CASE("Surds halfway between two binary64, and beside that by next to nothing") {
  test::property("any two neighbours: even and odd, subnormal, at the infinities", [] {
    const double low = *rc::gen::oneOf(anyFinite(), rc::gen::element(greatest, -infinity, -0x1p-1074, 0.0));
    const double high = std::nextafter(low, infinity);
    const Rational middle = (test::extended(low) + test::extended(high)) / 2;
    Rational scaled = middle;
    mpq_mul_2exp(scaled.backend().data(), middle.backend().data(), 1100);
    const Dyadic m(numerator(scaled), -1100);
    // A q of more than 128 bits is a root that the first interval does not find exactly.
    const Dyadic q = shifted(Dyadic(std::abs(*test::nonZero(anyFinite()))), *rc::gen::element(0, 300)) + 1;
    const Dyadic w = *test::nonZero(anyFinite());
    const bool low_is_even = std::bit_cast<std::uint64_t>(low) % 2 == 0;
    const double up = sign(w) > 0 ? high : low, down = sign(w) > 0 ? low : high;
    RC_ASSERT(round_to_binary64(beside(m, 0, q, w)) == (low_is_even ? low : high));
    RC_ASSERT(round_to_binary64(beside(m, 1, q, w)) == up);
    RC_ASSERT(round_to_binary64(beside(m, -1, q, w)) == down);
    RC_ASSERT(is_rounded(beside(m, 0, q, w)) && is_rounded(beside(m, 1, q, w)));
    RC_ASSERT(!quick_round(beside(m, 0, q, w)));
  });
}

TEST_CASE("A surd that cancels to any number of bits is rounded to the nearest") {
  test::property("√delta less its own first bits, and less the root itself", [] {
    const Dyadic delta = std::abs(*test::nonZero(anyFinite()));
    const auto bits = *rc::gen::resize(100, rc::gen::inRange(60, 1500));
    const SquareRoot root = square_root(delta, bits);
    const Dyadic w = *test::nonZero(anyFinite());
    RC_ASSERT(is_rounded({.x = root.value, .y = -1, .delta = delta, .w = w}));
    RC_ASSERT(is_rounded({.x = -(root.value + root.unit), .y = 1, .delta = delta, .w = w}));
    RC_ASSERT(is_rounded({.x = -root.value, .y = 1, .delta = square(root.value), .w = w}));
  });
  // 2⁻¹²⁰⁰ − √(2⁻²⁴⁰⁰ + 2⁻³⁰⁰⁰) < 0, which 128 bits do not tell from 0.
  const DyadicSurd tiny{
      .x = shifted(Dyadic(1), -1200), .y = -1, .delta = shifted(Dyadic(1), -2400) + shifted(Dyadic(1), -3000)};
  CHECK(std::signbit(round_to_binary64(tiny)));
  CHECK(is_rounded(tiny));
}

TEST_CASE("A surd that is 0 gives +0, a negative one too small for a binary64 gives −0") {
  CHECK_FALSE(std::signbit(round_to_binary64(DyadicSurd{.x = -3, .y = 1, .delta = 9, .w = -1})));
  CHECK_FALSE(std::signbit(round_to_binary64(DyadicSurd{.x = 0, .y = 0, .delta = 9, .w = -1})));
  const DyadicSurd tiny{.y = 1, .delta = shifted(Dyadic(2), -5000), .w = -1};
  CHECK(round_to_binary64(tiny) == 0);
  CHECK(std::signbit(round_to_binary64(tiny)));
}

TEST_CASE("A surd with a negative radicand or a denominator 0 is refused") {
  for (const DyadicSurd& wrong : {DyadicSurd{1, 1, -1, 1}, DyadicSurd{1, 1, 2, 0}}) {
    CHECK_THROWS_AS(sign(wrong), std::domain_error);
    CHECK_THROWS_AS(compare(wrong, {.x = 1}), std::domain_error);
    CHECK_THROWS_AS(compare({.x = 1}, wrong), std::domain_error);
    CHECK_THROWS_AS(round_to_binary64(wrong), std::domain_error);
  }
}

}  // namespace
}  // namespace durero::number
