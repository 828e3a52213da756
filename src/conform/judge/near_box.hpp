#pragma once
/// A filter by boxes in binary64, before exact tests of elements.

#include "conform/judge/allowance.hpp"
#include "durero/surface/bounds.hpp"

namespace durero::conform {

/// An upper bound of a number that is not negative, in binary64: greater by less than 2⁻⁵¹ of it, and by a few of the
/// least number.
inline double bound_above(const Dyadic& x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return std::nextafter(number::round_to_binary64(x), infinity);
}

/// The space beside boxes in which a moved triangle with a point may lie.
struct NearBox {
  glm::dvec3 point;  ///< each coordinate off by 2⁻⁵³ of itself at most
  double margin;     ///< 8δ or more, with δ of the largest M

  /// Whether a triangle of that box may have the point within 6δ. Each difference below is off by less than δ: a
  /// coordinate of the point is M at most, δ ≥ 2⁻⁴⁹·M, and the coordinate, and the sum with the margin, are rounded
  /// once.
  bool may_be_of(const surface::Box& box) const {
    for (int i = 0; i < 3; ++i) {
      if (point[i] < box.low[i] - margin || point[i] > box.high[i] + margin) return false;
    }
    return true;
  }
};

}  // namespace durero::conform
