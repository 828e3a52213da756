#include "number/binary64.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace durero::number {

Leading leading(const Dyadic& value) {
  const auto& backend = value.significand().backend();
  return leading_of_limbs(backend.limbs(), backend.size(), value.exponent());
}

double round_to_binary64(bool negative, const Leading& magnitude) {
  const auto signed_value = [&](double value) { return negative ? -value : value; };
  const std::int64_t top = magnitude.exponent + 63;  // 2^top ≤ |value| < 2^(top+1)
  if (top > 1023) return signed_value(std::numeric_limits<double>::infinity());
  if (top < -1075) return signed_value(0.0);
  // The result is a multiple of the unit in the last place of its binade, which is never less than 2⁻¹⁰⁷⁴; what lies
  // below that unit, 11 to 64 of the 64 bits, is dropped.
  const std::int64_t unit = std::max<std::int64_t>(top - 52, -1074);
  const auto drop = static_cast<int>(unit - magnitude.exponent);
  std::uint64_t kept = drop == 64 ? 0 : magnitude.bits >> drop;
  const std::uint64_t dropped = drop == 64 ? magnitude.bits : magnitude.bits & ((std::uint64_t{1} << drop) - 1);
  const std::uint64_t half = std::uint64_t{1} << (drop - 1);
  const bool above = dropped > half || (dropped == half && magnitude.inexact);
  const bool tie = dropped == half && !magnitude.inexact;
  if (above || (tie && kept % 2 == 1)) ++kept;
  // kept ≤ 2⁵³, so ldexp is exact, except that 2⁵³ · 2⁹⁷¹ = 2¹⁰²⁴ becomes the infinity that the rule asks for.
  return signed_value(std::ldexp(static_cast<double>(kept), static_cast<int>(unit)));
}

}  // namespace durero::number
