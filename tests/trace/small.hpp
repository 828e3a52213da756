/// Floating formats so small that every input of a plane can be tried, alone and two to a number, as double-double is
/// two binary64: number types for the templates of src/trace.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "durero/number/dyadic.hpp"
#include "trace/closed_form-inl.hpp"

namespace durero::test {

/// A number of so many bits of significand, and of any exponent. Each operation is binary64's, rounded to these bits:
/// that is their own correct rounding, as 53 ≥ 2·24 + 2 (Figueroa, 1995).
template <int digits>
struct Small {
  static_assert(53 >= 2 * digits + 2);
  double value = 0;

  Small() = default;
  Small(double x) : value(rounded(x)) {}

  // To nearest, ties to even: adding the half below the last bit kept carries into it where that is right.
  static double rounded(double x) {
    if (x == 0 || !std::isfinite(x)) return x;
    constexpr int dropped = 53 - digits;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t even = bits >> dropped & 1, below = (std::uint64_t{1} << (dropped - 1)) - 1;
    return std::bit_cast<double>((bits + below + even) >> dropped << dropped);
  }

  friend Small operator+(Small a, Small b) { return a.value + b.value; }
  friend Small operator-(Small a, Small b) { return a.value - b.value; }
  friend Small operator*(Small a, Small b) { return a.value * b.value; }
  friend Small operator/(Small a, Small b) { return a.value / b.value; }
  friend Small operator-(Small a) { return -a.value; }
  friend Small sqrt(Small a) { return std::sqrt(a.value); }
  friend Small abs(Small a) { return std::abs(a.value); }
  friend bool operator<(Small a, Small b) { return a.value < b.value; }
  friend bool operator>(Small a, Small b) { return a.value > b.value; }
  friend bool operator<=(Small a, Small b) { return a.value <= b.value; }

  /// a·b, exactly, as a fused multiply-subtract gives it. What stands in where there is none splits a binary64.
  friend trace::HWY_NAMESPACE::Twofold<Small> two_prod(Small a, Small b) {
    const Small product = a * b;
    return {product, a.value * b.value - product.value};
  }
};

/// A sum of two: the doubled format of which double-double is that of 53 digits.
template <int digits>
using Doubled = trace::HWY_NAMESPACE::Twofold<Small<digits>>;

/// What a number is, exactly.
template <int digits>
number::Dyadic whole(Small<digits> a) {
  return number::Dyadic(a.value);
}
template <int digits>
number::Dyadic whole(const Doubled<digits>& a) {
  return whole(a.hi) + whole(a.lo);
}

}  // namespace durero::test

namespace durero::trace::HWY_NAMESPACE {

template <int digits>
struct Numbers<test::Small<digits>> {
  using Small = test::Small<digits>;
  using Bound = double;
  static constexpr double roundoff = 1.0 / (1 << digits);
  static double leading(Small a) { return a.value; }
  static Small difference(double a, double b) { return a - b; }
};

/// As Numbers<DoubleDouble>: 16u², where u is the roundoff of one.
template <int digits>
struct Numbers<test::Doubled<digits>> {
  using Small = test::Small<digits>;
  using Bound = double;
  static constexpr double roundoff = 16 * Numbers<Small>::roundoff * Numbers<Small>::roundoff;
  static double leading(const test::Doubled<digits>& a) { return a.hi.value; }
  static test::Doubled<digits> difference(double a, double b) { return two_sum<Small>(a, -b); }
};

}  // namespace durero::trace::HWY_NAMESPACE
