#pragma once
/// What "rounded once to the nearest binary64, ties to even" says, written down without rounding anything.
#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>

#include "durero/number/rational.hpp"

namespace durero::test {

/// A binary64 as a rational; an infinity as ±2¹⁰²⁴, where its binade would begin, which is how IEEE 754 rounds to it.
inline number::Rational extended(double value) {
  if (std::isfinite(value)) return number::exact(value);
  const number::Rational half = number::exact(0x1p1023);
  return value > 0 ? half + half : -half - half;
}

/// True where `result` is the rounding of the number v, of which only its order against rationals is known:
/// `order(m)` is v <=> m. The zero must be −0 where v < 0, and +0 else.
template <class Order>
bool is_nearest(double result, Order order) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto order_against_middle = [&](double a, double b) {
    return order(number::Rational((extended(a) + extended(b)) / 2));
  };
  const bool even = std::bit_cast<std::uint64_t>(result) % 2 == 0;
  if (result > -infinity) {
    const auto below = order_against_middle(std::nextafter(result, -infinity), result);
    if (even ? below < 0 : below <= 0) return false;
  }
  if (result < infinity) {
    const auto above = order_against_middle(result, std::nextafter(result, infinity));
    if (even ? above > 0 : above >= 0) return false;
  }
  return result != 0 || std::signbit(result) == (order(number::Rational(0)) < 0);
}

}  // namespace durero::test
