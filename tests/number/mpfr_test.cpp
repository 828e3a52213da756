// Numbers rounded once, against MPFR as a second opinion: surds of every size, and surds built to lie close to the
// middle of two binary64, where a bound of quick_round that is too small by a few units would give the wrong one. And
// the enclosures of ball.hpp: how much of the radius the middle is off.
#include <fmt/core.h>
#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "durero/number/ball.hpp"
#include "durero/number/dyadic_surd.hpp"
#include "durero/number/quotient.hpp"
#include "durero/number/surd.hpp"
#include "number/quick_round.hpp"
#include "support/catch.hpp"
#include "support/exact_ratio.hpp"

using namespace durero;
using namespace durero::test;
using number::DyadicSurd;

namespace {

/// A number of MPFR's, of 6000 bits: the numbers below span some 4500, so what decides a rounding is among them.
class Real {
 public:
  Real() { mpfr_init2(value_, 6000); }
  explicit Real(const Dyadic& x) : Real() {
    const number::Rational exact = x.rational();
    mpfr_set_q(value_, exact.backend().data(), MPFR_RNDN);
  }
  ~Real() { mpfr_clear(value_); }
  Real(const Real&) = delete;
  Real& operator=(const Real&) = delete;

  double rounded() const { return mpfr_get_d(value_, MPFR_RNDN); }
  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

/// (x + y√delta)/w, by MPFR.
double by_mpfr(const DyadicSurd& value) {
  Real x(value.x), y(value.y), delta(value.delta), w(value.w);
  mpfr_sqrt(delta.get(), delta.get(), MPFR_RNDN);
  mpfr_mul(y.get(), y.get(), delta.get(), MPFR_RNDN);
  mpfr_add(x.get(), x.get(), y.get(), MPFR_RNDN);
  mpfr_div(x.get(), x.get(), w.get(), MPFR_RNDN);
  return x.rounded();
}

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : engine_(seed) {}
  std::uint64_t below(std::uint64_t n) { return engine_() % n; }
  int integer(int least, int greatest) {
    return least + static_cast<int>(below(static_cast<std::uint64_t>(greatest - least) + 1));
  }
  /// ±m·2^k with m in [1, 2) and k in ±range.
  double number(int range) {
    const double size = 1 + static_cast<double>(engine_() >> 12) * 0x1p-52;
    const double power = std::ldexp(1.0, integer(-range, range));
    return (below(2) == 0 ? size : -size) * power;
  }

 private:
  std::mt19937_64 engine_;
};

/// The surd rounds as MPFR has it, by both ways where the quick one tells. Whether it did.
bool agrees(const DyadicSurd& value) {
  const double expected = by_mpfr(value);
  const bool right = round_to_binary64(value) == expected || number::sign(value) == 0;
  const auto quick = quick_round(value);
  INFO(fmt::format("{:a} by MPFR, {:a}, {:a} quick", expected, round_to_binary64(value), quick.value_or(NAN)));
  CHECK(right);
  CHECK((!quick || *quick == expected));
  return quick.has_value();
}

}  // namespace

TEST_CASE("surds round as MPFR rounds them") {
  Numbers numbers(1);
  int quick = 0;
  for (int i = 0; i < 4000; ++i) {
    const int range = i % 4 == 0 ? 700 : i % 2 == 0 ? 60 : 3;
    const DyadicSurd value{numbers.number(range), numbers.number(range), std::abs(numbers.number(range)),
                           numbers.number(range)};
    quick += agrees(value);
  }
  CHECK(quick > 3000);
}

TEST_CASE("quotients and rationals round as MPFR rounds them") {
  Numbers numbers(2);
  for (int i = 0; i < 4000; ++i) {
    const int range = i % 2 == 0 ? 530 : 3;
    const Dyadic n(numbers.number(range)), d(numbers.number(range));
    const double expected = by_mpfr({.x = n, .w = d});
    CHECK(number::round_quotient(n, d) == expected);
    CHECK(number::round_to_binary64(n.rational() / d.rational()) == expected);
    CHECK(number::round_to_binary64(number::Surd(n.rational() / d.rational())) == expected);
  }
}

TEST_CASE("surds next to the middle of two binary64 round as MPFR rounds them") {
  // √delta·y is chosen as m·w − x, with m a middle, but for a part 2^-depth of it: (x + y√delta)/w is m within that.
  Numbers numbers(3);
  int quick = 0, slow = 0;
  for (int i = 0; i < 20000; ++i) {
    const double below = std::abs(numbers.number(3));
    const Dyadic middle = number::shifted(Dyadic(below) + Dyadic(std::nextafter(below, 9.0 * below)), -1);
    const Dyadic x(numbers.number(3)), w(numbers.number(3));
    const Dyadic rest = middle * w - x;
    if (number::sign(rest) == 0) continue;
    const int depth = numbers.integer(50, 140);
    const Dyadic off = number::shifted(rest * Dyadic(numbers.number(0)), -depth);
    const DyadicSurd value{x, number::sign(rest), square(rest + off), w};
    // The root is rational by construction; what follows it makes it a true surd, far below the rest.
    const DyadicSurd surd{value.x, value.y, value.delta + number::shifted(square(rest), -400), value.w};
    (agrees(surd) ? quick : slow) += 1;
  }
  CHECK(quick > 1000);
  CHECK(slow > 1000);
}

TEST_CASE("an enclosure holds the number, and is not much wider than need be") {
  Numbers numbers(4);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const int range = i % 3 == 0 ? 300 : 2;
    const Dyadic a(numbers.number(range)), b(numbers.number(range));
    const DyadicSurd value{a * a - b * b, numbers.number(range), a * a + b * b, numbers.number(range)};
    const number::RealBall ball = enclosure(value);
    const Fraction meant{value.x + value.y * root(value.delta), value.w};
    worst = std::max(worst, meant.ratio(number::shifted(Dyadic(ball.middle), ball.exponent),
                                        number::shifted(Dyadic(ball.radius), ball.exponent)));
  }
  fmt::print("ball: worst |middle − number|/radius of an enclosure: {:.4f}\n", worst);
  CHECK(worst <= 1);
  CHECK(worst >= 1.0 / 64);
}
