#pragma once
/// A line's crossings of planes across the axes, in an order that is decided exactly. Structures that divide space
/// traverse by it.
///
/// Space is divided by the half-open rule: the points x < plane are below a plane, the points x ≥ plane above it. Each
/// point is in one cell of a division, and the cells of a ray are those that hold a point of it. A ray that goes
/// forwards along the axis is above from the crossing's t on, t included; a ray that goes backwards is still above at
/// t, and below right after. Crossings therefore come in the order of t, and at the same t forward ones before backward
/// ones; crossings that agree in both coincide.
///
/// The parameter of a crossing is computed as (plane − p)·(1/v): three roundings, which together are less than 4u of
/// the computed one, u = 2⁻⁵³. Two parameters farther apart than 8u of their sum are in the order of the computed ones;
/// the comparison's own three roundings change that bound by less than a fourth of it, hence 2⁻⁴⁹. Exact numbers decide
/// where the parameters are nearer.

#include <cmath>
#include <glm/vec3.hpp>
#include <limits>

#include "durero/trace/ray.hpp"

namespace durero::accel {

/// A ray's crossing of a plane across an axis.
struct PlaneCrossing {
  double t;        ///< the parameter, within 4u of itself
  double plane;    ///< the coordinate of the plane
  int axis;        ///< the axis that the plane lies across: 0, 1 or 2
  bool backwards;  ///< whether the ray goes towards lesser coordinates
};

/// A ray, prepared for crossings of planes across the axes.
class AxisRay {
 public:
  /// Prepares a ray. Precondition: it is ordinary.
  explicit AxisRay(const trace::Ray& ray)
      : p_(ray.p), v_(ray.v), inverse_(1.0 / ray.v.x, 1.0 / ray.v.y, 1.0 / ray.v.z) {}

  const glm::dvec3& p() const { return p_; }  ///< the origin
  const glm::dvec3& v() const { return v_; }  ///< the direction
  /// Whether the ray goes towards lesser coordinates of the axis.
  bool backwards(int axis) const { return v_[axis] < 0; }

  /// The ray's start: its origin, at t = 0.
  PlaneCrossing start() const { return {0, p_[0], 0, false}; }
  /// A crossing after every other, where a ray has no end.
  static constexpr PlaneCrossing end() { return {2 * never, 0, 0, false}; }
  /// The crossing of a plane. A ray along the plane crosses it never, or before all other crossings where it is above.
  /// Precondition: the plane is 0 or of magnitude 2⁻¹⁵⁰ … 2¹⁵⁰, so that nothing underflows or overflows.
  PlaneCrossing crossing(int axis, double plane) const {
    if (v_[axis] == 0) return {plane <= p_[axis] ? -never : never, plane, axis, false};
    return {(plane - p_[axis]) * inverse_[axis], plane, axis, v_[axis] < 0};
  }

  /// The order of two crossings: negative, 0 or positive where a comes before b, coincides with it, or comes after it.
  int order(const PlaneCrossing& a, const PlaneCrossing& b) const {
    const double apart = a.t - b.t;
    if (std::abs(apart) > 0x1p-49 * (std::abs(a.t) + std::abs(b.t))) return apart < 0 ? -1 : 1;
    return order_exactly(a, b);
  }

  /// Whether the ray is above the plane right after `event`.
  bool above(int axis, double plane, const PlaneCrossing& event) const {
    const bool passed = order(crossing(axis, plane), event) <= 0;
    return passed != backwards(axis);
  }

  /// Whether all points of the ray from the crossing on lie beyond the limit.
  static bool beyond(const PlaneCrossing& from, double limit) { return from.t * (1 - 0x1p-50) > limit; }

 private:
  /// A bound of every crossing's parameter, which is less than 2¹⁵¹·2¹⁰⁰.
  static constexpr double never = 0x1p300;

  int order_exactly(const PlaneCrossing& a, const PlaneCrossing& b) const;

  glm::dvec3 p_, v_, inverse_;
};

}  // namespace durero::accel
