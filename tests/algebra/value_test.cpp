#include "durero/algebra/value.hpp"

#include <array>
#include <limits>

#include "durero/number/rational.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

namespace durero::algebra {
namespace {

using number::Dyadic;
using number::DyadicSurd;
using number::Rational;

constexpr double infinity = std::numeric_limits<double>::infinity();

Value at_cube_root_of_two(Polynomial numerator, Polynomial denominator) {
  const Polynomial of{-2, 0, 0, 1};
  return Fraction{std::move(numerator), std::move(denominator), of, positive_roots(of).at(0)};
}

/// The order as a number: −1, 0 or 1.
int side(const Value& a, const auto& b) {
  const auto order = compare(a, b);
  return order < 0 ? -1 : order > 0 ? 1 : 0;
}

/// The same rational number as a surd, and as a function of a root that it does not depend on.
std::array<Value, 2> both(const Dyadic& n, const Dyadic& d) {
  return {DyadicSurd{.x = n, .w = d}, at_cube_root_of_two({n}, {d})};
}

}  // namespace

TEST_CASE(
    "A function of a root is compared with numbers, with surds and with functions of other roots, ties included") {
  const Value root = at_cube_root_of_two({0, 1}, {1});  // 1.2599…
  CHECK(side(root, Dyadic(1.25)) == 1);
  CHECK(side(root, Dyadic(1.26)) == -1);
  CHECK(side(root, Value(DyadicSurd{0, 1, 2, 1})) == -1);  // √2
  CHECK(side(root, Value(DyadicSurd{-1, 1, 5, 1})) == 1);  // √5 − 1
  // α² is the cube root of four, the root of another polynomial; 2/α too.
  const Polynomial of_four{-4, 0, 0, 1};
  const Value four = Fraction{{0, 1}, {1}, of_four, positive_roots(of_four).at(0)};
  CHECK(side(at_cube_root_of_two({0, 0, 1}, {1}), four) == 0);
  CHECK(side(four, at_cube_root_of_two({2}, {0, 1})) == 0);
  CHECK(side(at_cube_root_of_two({0x1p-300, 0, 1}, {1}), four) == 1);
  CHECK(side(four, at_cube_root_of_two({0x1p-300, 0, 1}, {1})) == -1);
  // Where the denominator is negative, and where the value is.
  CHECK(side(at_cube_root_of_two({-2}, {0, -1}), four) == 0);
  CHECK(side(at_cube_root_of_two({2}, {0, -1}), four) == -1);
  CHECK(sign(at_cube_root_of_two({2}, {0, -1})) == -1);
  CHECK(sign(at_cube_root_of_two({-2, 0, 0, 1}, {1})) == 0);  // α³ − 2
  CHECK(sign(at_cube_root_of_two({}, {1})) == 0);
  // √2 as the root of t⁴ − 4, and as a surd.
  const Polynomial of_quartic{-4, 0, 0, 0, 1};
  const Value quartic = Fraction{{0, 1}, {1}, of_quartic, positive_roots(of_quartic).at(0)};
  CHECK(side(quartic, Value(DyadicSurd{0, 1, 2, 1})) == 0);
  CHECK(side(Value(DyadicSurd{0, -1, 2, -1}), quartic) == 0);
  CHECK(side(quartic, Value(DyadicSurd{0x1p-400, 1, 2, 1})) == -1);
}

TEST_CASE("A value is rounded once: to the even one of two that are as near, to infinities and to zeros") {
  test::property("a fraction, however it is written, rounds as a rational does", [] {
    const auto n = *rc::gen::inRange<int>(-1000, 1000), d = *rc::gen::inRange<int>(1, 1000);
    const auto shift = *rc::gen::element(-1080, -1074, -1022, -3, 0, 7, 1015, 1024);
    const Dyadic numerator = number::shifted(n, shift);
    const double expected = number::round_to_binary64(Rational(numerator.rational() / d));
    for (const Value& value : both(numerator, d)) {
      const double rounded = round_to_binary64(value);
      RC_ASSERT(rounded == expected);
      RC_ASSERT(std::signbit(rounded) == std::signbit(expected));
    }
  });
  const Dyadic half_way = Dyadic(1.0) + Dyadic(0x1p-53), other = Dyadic(1 + 0x1p-52) + Dyadic(0x1p-53);
  const Dyadic over = number::shifted(1, 1024) - number::shifted(1, 970);
  for (const bool above : {false, true}) {
    const auto value = [&](const Dyadic& number) { return both(number, 1)[above ? 1 : 0]; };
    CHECK(round_to_binary64(value(half_way)) == 1);
    CHECK(round_to_binary64(value(other)) == 1 + 0x1p-51);
    CHECK(round_to_binary64(value(over)) == infinity);
    CHECK(round_to_binary64(value(-over)) == -infinity);
    CHECK(round_to_binary64(value(over - Dyadic(1))) == std::numeric_limits<double>::max());
    CHECK(round_to_binary64(value(number::shifted(1, -1075))) == 0);
    CHECK(std::signbit(round_to_binary64(value(number::shifted(-1, -1075)))));
    CHECK_FALSE(std::signbit(round_to_binary64(value(0))));
  }
}

TEST_CASE("A root of a value is rounded once") {
  test::property("the root lies between the numbers that round to its rounding", [] {
    const Dyadic n(*rc::gen::inRange<int>(0, 1 << 20)), d(*rc::gen::inRange<int>(1, 1 << 20));
    for (const Value& value : both(n, d)) {
      const double root = rounded_root(value);
      const Rational below = number::exact(root) + number::exact(std::nextafter(root, -1.0)),
                     above = number::exact(root) + number::exact(std::nextafter(root, infinity));
      const Rational four_times = 4 * n.rational() / d.rational();
      RC_ASSERT(root == 0 || below * below <= four_times);
      RC_ASSERT(four_times <= above * above);
    }
  });
  const Dyadic half_way = Dyadic(1.0) + Dyadic(0x1p-53), other = Dyadic(1 + 0x1p-52) + Dyadic(0x1p-53);
  for (const std::size_t which : {0U, 1U}) {
    CHECK(rounded_root(both(number::square(half_way), 1)[which]) == 1);
    CHECK(rounded_root(both(number::square(other), 1)[which]) == 1 + 0x1p-51);
    CHECK(rounded_root(both(number::square(half_way) + Dyadic(0x1p-900), 1)[which]) == 1 + 0x1p-52);
    CHECK(rounded_root(both(number::shifted(9, 2000), 4)[which]) == 1.5 * 0x1p1000);
    CHECK(rounded_root(both(number::shifted(9, -2146), 1)[which]) == 3 * 0x1p-1073);
    CHECK(rounded_root(both(number::shifted(1, 2048), 1)[which]) == infinity);
    CHECK(rounded_root(both(0, 1)[which]) == 0);
  }
  // √(α² + 2/α) of the cube root α of two: √(2·4^(1/3)), 1.7817974362806785482…
  CHECK(rounded_root(at_cube_root_of_two({2, 0, 0, 1}, {0, 1})) == 1.7817974362806785482);
}

TEST_CASE("A refined root is the same root in a shorter interval") {
  const Root root = positive_roots({-2, 0, 0, 1}).at(0), fine = refined(root, 300);
  CHECK((compare(root, fine) == 0));
  const auto& interval = std::get<Isolated>(fine);
  CHECK(interval.high - interval.low <= number::shifted(interval.high, -300));
  CHECK(std::holds_alternative<DyadicSurd>(refined(DyadicSurd{1, 1, 2, 1}, 300)));
}

}  // namespace durero::algebra
