#pragma once
/// Rounding from the leading 128 bits: the step that round_to_binary64 of a DyadicSurd takes first.
#include <optional>

#include "durero/number/dyadic_surd.hpp"

namespace durero::number {

/// The value rounded, or nothing where 128 bits of each part cannot tell: x and y√delta nearly cancel, or the value is
/// within about 2⁻⁶⁰ of its size of the middle of two binary64. Precondition: delta ≥ 0, w ≠ 0, and x or y√delta is not
/// 0.
std::optional<double> quick_round(const DyadicSurd& value);

}  // namespace durero::number
