#include "durero/number/dyadic.hpp"

#include <limits>
#include <sstream>

#include "number/integers.hpp"
#include "support/catch.hpp"
#include "support/doubles.hpp"
#include "support/nearest.hpp"
#include "support/property.hpp"

namespace durero::number {
namespace {

using test::anyFinite;
using test::dyadicGrid;
using test::moderate;

/// Products and sums of a few doubles: many sizes of significand, trailing zeros, cancellations.
rc::Gen<Dyadic> anyDyadic() {
  const auto number = rc::gen::oneOf(anyFinite(), moderate(), dyadicGrid());
  return rc::gen::apply(
      [](double a, double b, double c, double d) { return Dyadic(a) * Dyadic(b) * Dyadic(c) - Dyadic(b) * Dyadic(d); },
      number, number, number, number);
}

TEST_CASE("A Dyadic made from a binary64 is the number that it denotes") {
  test::property("and rounds back to it", [] {
    const double value = *anyFinite();
    RC_ASSERT(Dyadic(value).rational() == exact(value));
    RC_ASSERT(round_to_binary64(Dyadic(value)) == value);
    RC_ASSERT(sign(Dyadic(value)) == (value > 0) - (value < 0));
  });
  CHECK(Dyadic(-3).rational() == -3);
  CHECK(sign(Dyadic(-0.0)) == 0);
  CHECK_FALSE(std::signbit(round_to_binary64(Dyadic(-0.0))));
  CHECK_THROWS_AS(Dyadic(std::numeric_limits<double>::infinity()), std::domain_error);
  CHECK_THROWS_AS(Dyadic(std::numeric_limits<double>::quiet_NaN()), std::domain_error);
}

TEST_CASE("Arithmetic on Dyadics is that of the rationals") {
  test::property("+ - * and order", [] {
    const Dyadic a = *anyDyadic();
    const Dyadic b = *anyDyadic();
    const Rational p = a.rational();
    const Rational q = b.rational();
    RC_ASSERT((a + b).rational() == p + q);
    RC_ASSERT((a - b).rational() == p - q);
    RC_ASSERT((a * b).rational() == p * q);
    RC_ASSERT((-a).rational() == -p);
    RC_ASSERT(square(a).rational() == p * p);
    RC_ASSERT((a < b) == (p < q));
    RC_ASSERT((a > b) == (p > q));
    RC_ASSERT((a == b) == (p == q));
    RC_ASSERT(sign(a) == sign(p));
  });
  test::property("equality looks through the representation", [] {
    const Dyadic a = *anyDyadic();
    const Dyadic b = *anyDyadic();
    const Dyadic same = (a + b) - b;
    RC_ASSERT(same == a);
    RC_ASSERT(!(same < a || same > a));
    RC_ASSERT(sign(same - a) == 0);
  });
}

TEST_CASE("Significands about as wide as one or two limbs add and multiply as GMP's do") {
  std::vector<Integer> numbers{0};
  for (const int bits : {1, 53, 62, 63, 64, 65, 66, 96, 124, 125, 126, 127, 128, 129, 130}) {
    const Integer ones = (Integer(1) << bits) - 1, one = Integer(1) << (bits - 1), mixed = ones / 3 * 2 + 1;
    for (const Integer& number : {ones, one, mixed}) numbers.insert(numbers.end(), {number, Integer(-number)});
  }
  std::size_t wrong = 0;
  for (const Integer& a : numbers) {
    for (const Integer& b : numbers) {
      wrong += to_integer((Dyadic(a, 0) * Dyadic(b, 0)).significand()) != a * b;
      for (const int shift : {0, 1, 2, 61, 63, 64, 65, 125, 127}) {
        const Integer higher = a << shift;
        const Dyadic m(a, shift), n(b, 0);
        wrong += (m + n).rational() != higher + b;
        wrong += (m - n).rational() != higher - b;
        wrong += (n - m).rational() != b - higher;
      }
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("Significands of thousands of bits multiply as GMP's do") {
  test::property("products, squares and sums", [] {
    const auto limbs =
        *rc::gen::container<std::vector<std::uint64_t>>(*rc::gen::resize(100, rc::gen::inRange<std::size_t>(1, 300)),
                                                        rc::gen::resize(100, rc::gen::arbitrary<std::uint64_t>()));
    Integer a = 0;
    for (const std::uint64_t limb : limbs) a = (a << 64) + limb;
    const Integer b = -(a >> 1000) - 1;
    RC_ASSERT(to_integer((Dyadic(a, 0) * Dyadic(b, 0)).significand()) == a * b);
    RC_ASSERT(to_integer((Dyadic(a, 0) * Dyadic(a, 0)).significand()) == a * a);
    RC_ASSERT(to_integer((Dyadic(a, 0) + Dyadic(b, 0)).significand()) == a + b);
  });
}

TEST_CASE("shifted multiplies by a power of two; floor_log2 is the exponent of the leading bit") {
  CHECK(shifted(Dyadic(3), 4) == 48);
  CHECK(shifted(Dyadic(3), -1) == 1.5);
  CHECK(sign(shifted(Dyadic(0), 99)) == 0);
  CHECK(floor_log2(Dyadic(1)) == 0);
  CHECK(floor_log2(Dyadic(-0.75)) == -1);
  CHECK(floor_log2(Dyadic(0x1p-1074)) == -1074);
  test::property("2^floor_log2(a) ≤ |a| < 2^(floor_log2(a) + 1)", [] {
    const Dyadic a = *anyDyadic();
    RC_PRE(sign(a) != 0);
    const Dyadic size = sign(a) < 0 ? -a : a;
    RC_ASSERT(shifted(Dyadic(1), floor_log2(a)) <= size);
    RC_ASSERT(size < shifted(Dyadic(1), floor_log2(a) + 1));
  });
}

TEST_CASE("A Dyadic is rounded to the nearest binary64, ties to even") {
  test::property("any", [] {
    const Dyadic value = *anyDyadic();
    RC_ASSERT(test::is_nearest(round_to_binary64(value),
                               [&, v = value.rational()](const Rational& m) { return sign(Rational(v - m)) <=> 0; }));
  });
  test::property("halfway, and beside it by less than any binary64", [] {
    const double low = *anyFinite();
    RC_PRE(low < std::numeric_limits<double>::max());
    const double high = std::nextafter(low, std::numeric_limits<double>::infinity());
    const Dyadic middle = shifted(Dyadic(low) + Dyadic(high), -1);
    const auto below = *rc::gen::oneOf(rc::gen::resize(100, rc::gen::inRange(1, 200)), rc::gen::just(4000));
    const Dyadic nudge = shifted(Dyadic(high) - Dyadic(low), -1 - below);
    RC_ASSERT(round_to_binary64(middle) == (std::bit_cast<std::uint64_t>(low) % 2 == 0 ? low : high));
    RC_ASSERT(round_to_binary64(middle - nudge) == low);
    RC_ASSERT(round_to_binary64(middle + nudge) == high);
  });
}

}  // namespace
}  // namespace durero::number
