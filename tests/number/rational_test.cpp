#include "durero/number/rational.hpp"

#include <algorithm>
#include <limits>

#include "support/catch.hpp"
#include "support/doubles.hpp"
#include "support/nearest.hpp"
#include "support/property.hpp"

namespace durero::number {
namespace {

using test::anyFinite;
using test::is_nearest;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double greatest = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();

bool is_rounded(const Rational& value) {
  return is_nearest(round_to_binary64(value), [&](const Rational& m) {
    return value < m   ? std::strong_ordering::less
           : value > m ? std::strong_ordering::greater
                       : std::strong_ordering::equal;
  });
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

Rational power_of_two(int exponent) {
  Rational result = 1;
  for (int i = 0; i < std::abs(exponent); ++i) result = exponent > 0 ? result * 2 : result / 2;
  return result;
}

TEST_CASE("exact: a binary64 denotes exactly the rational number that it is") {
  CHECK(exact(0.1) == Rational("3602879701896397/36028797018963968"));
  CHECK(exact(-0.0) == 0);
  CHECK(exact(least) == power_of_two(-1074));
  CHECK(exact(greatest) == power_of_two(1024) - power_of_two(971));
  CHECK_THROWS_AS(exact(infinity), std::domain_error);
  CHECK_THROWS_AS(exact(std::numeric_limits<double>::quiet_NaN()), std::domain_error);
}

TEST_CASE("round_to_binary64 gives back every binary64, and +0 for zero") {
  test::property("idempotent", [] {
    const double value = *anyFinite();
    RC_ASSERT(same_bits(round_to_binary64(exact(value)), value == 0 ? 0.0 : value));
  });
}

TEST_CASE("round_to_binary64 takes the nearest") {
  test::property("of quotients", [] {
    const double n = *anyFinite();
    const double d = *test::nonZero(anyFinite());
    RC_ASSERT(is_rounded(exact(n) / exact(d)));
  });
  test::property("as the machine's own division, addition and multiplication do", [] {
    const double a = *anyFinite();
    const double b = *test::nonZero(anyFinite());
    RC_ASSERT(round_to_binary64(exact(a) / exact(b)) == a / b);
    RC_ASSERT(round_to_binary64(exact(a) * exact(b)) == a * b);
    RC_ASSERT(round_to_binary64(exact(a) + exact(b)) == a + b);
  });
  test::property("and is monotone", [] {
    const Rational a = exact(*anyFinite()) / 3;
    const Rational b = exact(*anyFinite()) / 7;
    RC_ASSERT(round_to_binary64(std::min(a, b)) <= round_to_binary64(std::max(a, b)));
  });
}

TEST_CASE("round_to_binary64 settles ties to even") {
  test::property("between any two neighbours, subnormal ones too", [] {
    const double low = *anyFinite();
    RC_PRE(low < greatest);
    const double high = std::nextafter(low, infinity);
    const Rational middle = (exact(low) + exact(high)) / 2;
    const bool low_is_even = std::bit_cast<std::uint64_t>(low) % 2 == 0;
    RC_ASSERT(round_to_binary64(middle) == (low_is_even ? low : high));
    RC_ASSERT(is_rounded(middle));
    const Rational nudge = power_of_two(-1200);
    RC_ASSERT(round_to_binary64(middle - nudge) == low);
    RC_ASSERT(round_to_binary64(middle + nudge) == high);
  });
}

TEST_CASE("round_to_binary64 at the ends of the range") {
  const Rational threshold = power_of_two(1024) - power_of_two(970);
  const Rational nudge = power_of_two(-1000);
  CHECK(round_to_binary64(threshold) == infinity);
  CHECK(round_to_binary64(threshold - nudge) == greatest);
  CHECK(round_to_binary64(-threshold) == -infinity);
  CHECK(round_to_binary64(nudge - threshold) == -greatest);
  CHECK(round_to_binary64(power_of_two(5000)) == infinity);

  const Rational half_least = power_of_two(-1075);
  CHECK(same_bits(round_to_binary64(half_least), 0.0));
  CHECK(same_bits(round_to_binary64(-half_least), -0.0));
  CHECK(round_to_binary64(half_least + power_of_two(-3000)) == least);
  CHECK(round_to_binary64(-half_least - power_of_two(-3000)) == -least);
  CHECK(round_to_binary64(3 * half_least) == 2 * least);
  CHECK(same_bits(round_to_binary64(-power_of_two(-5000)), -0.0));
  CHECK(same_bits(round_to_binary64(Rational(0)), 0.0));
}

TEST_CASE("rational_sqrt finds the root exactly where it is rational") {
  CHECK(rational_sqrt(Rational(9, 4)) == Rational(3, 2));
  CHECK(rational_sqrt(Rational(0)) == Rational(0));
  CHECK(rational_sqrt(Rational(2)) == std::nullopt);
  CHECK(rational_sqrt(Rational(4, 3)) == std::nullopt);
  CHECK(rational_sqrt(Rational(-4)) == std::nullopt);
  test::property("of squares", [] {
    const Rational root = abs(exact(*anyFinite())) / 3;
    RC_ASSERT(rational_sqrt(root * root) == root);
    RC_ASSERT(root == 0 || rational_sqrt(root * root * 2) == std::nullopt);
  });
}

}  // namespace
}  // namespace durero::number
