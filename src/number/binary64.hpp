#pragma once
/// The leading 64 bits of a number, and the one place where a binary64 is rounded.
#include <cstdint>

#include "durero/number/dyadic.hpp"

namespace durero::number {

/// |value| = (bits + f) · 2^exponent with bits ≥ 2⁶³ and 0 ≤ f < 1; inexact means f ≠ 0.
struct Leading {
  std::uint64_t bits;
  std::int64_t exponent;
  bool inexact;
};

/// Precondition: value ≠ 0.
Leading leading(const Dyadic& value);
Leading leading(const Integer& value);

/// The nearest binary64 to the number of that magnitude, ties to even.
double round_to_binary64(bool negative, const Leading& magnitude);

}  // namespace durero::number
