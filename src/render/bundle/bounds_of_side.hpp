#pragma once
/// The sign of a linear function of the pixel plane, in binary64 where that can tell it.

#include <cmath>

#include "durero/number/rational.hpp"
#include "durero/polygon/convex.hpp"

namespace durero::render {

/// A linear function a·x + b·y + c with rounded coefficients, and bounds on its exact value.
///
/// Each coefficient errs by 2⁻⁵³ of itself, and so do x and y where they are rounded; a product of both errs by less
/// than 2⁻⁵¹ of itself, its own rounding included, and the two sums by 2⁻⁵² of the magnitudes. All is less than 2⁻⁴⁸ of
/// the sum of the magnitudes. What underflows is less than 2⁻¹⁰⁰⁰. Where a number overflows the bounds are infinite or
/// NaN, and tell nothing.
class SideBounds {
 public:
  explicit SideBounds(const polygon::PlaneSide& side)
      : a_(number::round_to_binary64(side.normal.x)),
        b_(number::round_to_binary64(side.normal.y)),
        c_(-number::round_to_binary64(side.offset)) {}

  /// Whether the function is positive at every point whose coordinates differ from (x, y) by at most `reach`.
  bool surely_positive(double x, double y, double reach = 0) const { return value(x, y) > error(x, y, reach); }
  /// Whether it is negative at every such point.
  bool surely_negative(double x, double y, double reach = 0) const { return value(x, y) < -error(x, y, reach); }

 private:
  double value(double x, double y) const { return a_ * x + b_ * y + c_; }
  double error(double x, double y, double reach) const {
    const double across = std::abs(a_ * x) + std::abs(b_ * y) + std::abs(c_);
    return 0x1p-48 * across + (1 + 0x1p-48) * (std::abs(a_) + std::abs(b_)) * reach + 0x1p-1000;
  }

  double a_, b_, c_;
};

}  // namespace durero::render
