#include "number/binary64.hpp"

#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/doubles.hpp"
#include "support/nearest.hpp"
#include "support/property.hpp"

namespace durero::number {
namespace {

constexpr std::uint64_t top_bit = std::uint64_t{1} << 63;

/// (bits + f)·2^exponent, where f is ¼ for what is inexact: any other f between 0 and 1 rounds alike.
Rational meant(const Leading& magnitude) {
  Rational value = Rational(Integer(magnitude.bits)) + (magnitude.inexact ? Rational(1, 4) : Rational(0));
  for (std::int64_t i = 0; i < std::abs(magnitude.exponent); ++i)
    value = magnitude.exponent < 0 ? Rational(value / 2) : Rational(value * 2);
  return value;
}

rc::Gen<std::uint64_t> any_bits() { return rc::gen::resize(100, rc::gen::arbitrary<std::uint64_t>()); }

TEST_CASE("the leading bits of a number, and whether that is all of it") {
  test::property("of m·2^e with m of any length", [] {
    const std::uint64_t high = *any_bits() | top_bit, low = *any_bits();
    const auto shift = *rc::gen::resize(100, rc::gen::inRange(1, 700));
    Integer m = (Integer(high) << 64) + low;
    m <<= static_cast<unsigned>(shift);
    const Leading of_integer = leading(m), of_dyadic = leading(-Dyadic(m, -900));
    RC_ASSERT(of_integer.bits == high);
    RC_ASSERT(of_integer.exponent == 64 + shift);
    RC_ASSERT(of_integer.inexact == (low != 0));
    RC_ASSERT(of_dyadic.bits == high);
    RC_ASSERT(of_dyadic.exponent == 64 + shift - 900);
    RC_ASSERT(of_dyadic.inexact == (low != 0));
  });
  const Leading one = leading(Integer(1));
  CHECK(one.bits == top_bit);
  CHECK(one.exponent == -63);
  CHECK_FALSE(one.inexact);
  CHECK(leading((Integer(1) << 5000) + 1).inexact);
}

TEST_CASE("the leading bits and the fraction behind them are rounded once") {
  test::property("over the whole range and beyond it", [] {
    const Leading magnitude{*any_bits() | top_bit, *rc::gen::resize(100, rc::gen::inRange(-1200, 1000)),
                            *rc::gen::arbitrary<bool>()};
    const bool negative = *rc::gen::arbitrary<bool>();
    const Rational value = negative ? Rational(-meant(magnitude)) : meant(magnitude);
    RC_ASSERT(test::is_nearest(round_to_binary64(negative, magnitude),
                               [&](const Rational& m) { return sign(Rational(value - m)) <=> 0; }));
  });
}

TEST_CASE("halfway the even one, and a fraction beyond that the greater") {
  // 1 + 2⁻⁵³ is in the middle of 1, which is even, and the next number.
  const std::uint64_t middle = top_bit | std::uint64_t{1} << 10;
  CHECK(round_to_binary64(false, {middle, -63, false}) == 1);
  CHECK(round_to_binary64(false, {middle, -63, true}) == std::nextafter(1.0, 2.0));
  CHECK(round_to_binary64(false, {middle | std::uint64_t{1} << 11, -63, false}) == 1 + 0x1p-51);
}

TEST_CASE("the ends of the range") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double greatest = std::numeric_limits<double>::max();
  const std::uint64_t all = ~std::uint64_t{0};
  CHECK(round_to_binary64(false, {all << 11, 960, false}) == greatest);
  CHECK(round_to_binary64(false, {all << 10, 960, false}) == infinity);  // 2¹⁰²⁴ − 2⁹⁷⁰
  CHECK(round_to_binary64(true, {top_bit, 961, false}) == -infinity);
  CHECK(round_to_binary64(false, {top_bit, -1074 - 63, false}) == 0x1p-1074);
  // Half of the least number is in the middle of it and 0, which is even.
  CHECK(round_to_binary64(false, {top_bit, -1075 - 63, true}) == 0x1p-1074);
  const double zero = round_to_binary64(true, {top_bit, -1075 - 63, false});
  CHECK(zero == 0);
  CHECK(std::signbit(zero));
  CHECK(round_to_binary64(false, {all, -1076 - 63, true}) == 0);
}

}  // namespace
}  // namespace durero::number
