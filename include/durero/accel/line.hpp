#pragma once
/// In which order a ray crosses planes across the axes, decided exactly: structures that divide space walk by it.
///
/// Space is divided by the half-open rule: of the two sides of a plane, the points x < plane are below and the points
/// x ≥ plane are above. So each point is in one cell of a division, and the cells of a ray are those that hold a point
/// of it, were it one point. A ray that goes forwards along the axis is above from the crossing's t on, t included; one
/// that goes backwards is still above at t, and below right after. Crossings therefore come in the order of t, and at
/// the same t forward ones before backward ones; those that are alike in both happen as one.
///
/// The parameter of a crossing is computed as (plane − p)·(1/v): three roundings, which together are less than 4u of
/// the computed one, u = 2⁻⁵³. Two parameters farther apart than 8u of their sum are in the order of the computed ones;
/// the comparison's own three roundings change that bound by less than a fourth of it, hence 2⁻⁴⁹. Where they are
/// nearer, exact numbers decide.

#include <cmath>
#include <glm/vec3.hpp>
#include <limits>

#include "durero/trace/ray.hpp"

namespace durero::accel {

/// Where a ray crosses a plane across an axis.
struct Crossing {
  double t;        ///< its parameter, within 4u of itself
  double plane;    ///< the coordinate of the plane
  int axis;        ///< that it lies across: 0, 1 or 2
  bool backwards;  ///< the ray goes towards lesser coordinates
};

/// A ray as planes across the axes are asked about it.
class Line {
 public:
  /// Of an ordinary ray.
  explicit Line(const trace::Ray& ray) : p_(ray.p), v_(ray.v), inverse_(1.0 / ray.v.x, 1.0 / ray.v.y, 1.0 / ray.v.z) {}

  const glm::dvec3& p() const { return p_; }  ///< the origin
  const glm::dvec3& v() const { return v_; }  ///< the direction
  /// Whether it goes towards lesser coordinates of the axis.
  bool backwards(int axis) const { return v_[axis] < 0; }

  /// Where the ray begins: its origin, at t = 0.
  Crossing start() const { return {0, p_[0], 0, false}; }
  /// After every other: where there is no end.
  static constexpr Crossing end() { return {2 * never, 0, 0, false}; }
  /// The crossing of a plane. A ray along the plane never crosses it, or has crossed it since ever where it is above.
  /// Precondition: the plane is 0 or of magnitude 2⁻¹⁵⁰ … 2¹⁵⁰, so that nothing underflows or overflows.
  Crossing crossing(int axis, double plane) const {
    if (v_[axis] == 0) return {plane <= p_[axis] ? -never : never, plane, axis, false};
    return {(plane - p_[axis]) * inverse_[axis], plane, axis, v_[axis] < 0};
  }

  /// Negative, 0 or positive: the first comes before the other, happens with it, or comes after it.
  int order(const Crossing& a, const Crossing& b) const {
    const double apart = a.t - b.t;
    if (std::abs(apart) > 0x1p-49 * (std::abs(a.t) + std::abs(b.t))) return apart < 0 ? -1 : 1;
    return order_exactly(a, b);
  }

  /// Right after `event` the ray is above the plane.
  bool above(int axis, double plane, const Crossing& event) const {
    const bool passed = order(crossing(axis, plane), event) <= 0;
    return passed != backwards(axis);
  }

  /// All that the ray meets from the crossing on lies beyond the limit.
  static bool beyond(const Crossing& from, double limit) { return from.t * (1 - 0x1p-50) > limit; }

 private:
  /// Greater than every parameter of a crossing: they are less than 2¹⁵¹·2¹⁰⁰.
  static constexpr double never = 0x1p300;

  int order_exactly(const Crossing& a, const Crossing& b) const;

  glm::dvec3 p_, v_, inverse_;
};

}  // namespace durero::accel
