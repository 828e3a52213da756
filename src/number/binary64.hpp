#pragma once
/// The leading 64 bits of a number, and the one place where a binary64 is rounded.
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "durero/number/dyadic.hpp"

namespace durero::number {

/// |value| = (bits + f) · 2^exponent with bits ≥ 2⁶³ and 0 ≤ f < 1; inexact means f ≠ 0.
struct Leading {
  std::uint64_t bits;
  std::int64_t exponent;
  bool inexact;
};

/// Of a number given by its limbs of 64 bits, the least significant first, the last one not 0.
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

/// Precondition: value ≠ 0.
Leading leading(const Dyadic& value);
Leading leading(const Integer& value);

/// The nearest binary64 to the number of that magnitude, ties to even.
double round_to_binary64(bool negative, const Leading& magnitude);

}  // namespace durero::number
