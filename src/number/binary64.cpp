#include "number/binary64.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

namespace durero::number {
namespace {

static_assert(sizeof(boost::multiprecision::limb_type) == 8 && sizeof(mp_limb_t) == 8,
              "both libraries use 64-bit limbs");

/// Of a number given by its limbs, the least significant first, the last one not 0.
template <class Limb>
Leading leading_of_limbs(const Limb* limbs, std::size_t size, std::int64_t exponent) {
  const int shift = std::countl_zero(static_cast<std::uint64_t>(limbs[size - 1]));
  std::uint64_t bits = limbs[size - 1] << shift;
  std::size_t rest = size - 1;
  bool inexact = false;
  if (rest > 0 && shift > 0) {
    --rest;
    bits |= limbs[rest] >> (64 - shift);
    inexact = (limbs[rest] << shift) != 0;
  }
  inexact = inexact || std::any_of(limbs, limbs + rest, [](Limb limb) { return limb != 0; });
  return {bits, exponent + 64 * (static_cast<std::int64_t>(size) - 1) - shift, inexact};
}

}  // namespace

Leading leading(const Dyadic& value) {
  const auto& backend = value.significand().backend();
  return leading_of_limbs(backend.limbs(), backend.size(), value.exponent());
}

Leading leading(const Integer& value) {
  const auto* data = value.backend().data();
  return leading_of_limbs(mpz_limbs_read(data), mpz_size(data), 0);
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
