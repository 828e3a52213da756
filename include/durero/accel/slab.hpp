#pragma once
/// The slab test of a ray against an axis-aligned box, in binary64. It never rejects a box in which the ray has a point
/// up to the limit: proofs/Slab.v, slab64_never_rejects, is about these operations in this order.
///
/// The bounds are these. A ray crosses the planes of an axis at (plane − p)·(1/v), with three roundings, each within u
/// = 2⁻⁵³ of its result or, where it underflows, within 2⁻¹⁰⁷⁵. The ray enters the box at the latest of the near
/// crossings and of 0, and leaves it at the earliest of the far ones and of the limit. Three roundings of each side and
/// two of the comparison are less than 16u, hence `grow`; underflow adds less than the least normal number, `tiny`.
/// The inverse of a component of v that is 0 is an infinity. A crossing is then an infinity of the right sign, or NaN
/// in the plane itself, which no comparison prefers.

#include <cmath>
#include <glm/vec3.hpp>

#include "durero/surface/bounds.hpp"
#include "durero/trace/ray.hpp"

namespace durero::accel {

inline constexpr double grow = 1 + 0x1p-49;  ///< 1 + 16u
inline constexpr double tiny = 0x1p-1022;    ///< the least normal number

/// A ray, prepared for tests against boxes.
struct Beam {
  /// Prepares a ray. Precondition: it is ordinary.
  explicit Beam(const trace::Ray& ray) : p(ray.p), inverse(1 / ray.v.x, 1 / ray.v.y, 1 / ray.v.z) {}

  glm::dvec3 p;        ///< origin
  glm::dvec3 inverse;  ///< 1/v by component; infinite where v is 0
};

/// The parameters entry … exit at which a ray may be within a box, each with the errors that `meets` allows for.
struct BoxInterval {
  double entry;  ///< not less than 0
  double exit;   ///< not more than the limit
  /// Whether the ray may have a point of the box up to the limit; false only where it has none.
  bool meets() const { return entry <= exit * grow + tiny; }
};

/// The stretch of a ray in a box up to a limit. Preconditions: the planes and p are of magnitude 2¹⁰²² or less; the
/// limit is not less than 0, and may be infinite.
inline BoxInterval stretch(const surface::Box& box, const Beam& beam, double limit) {
  BoxInterval result{0, limit};
  for (int i = 0; i < 3; ++i) {
    const bool backwards = std::signbit(beam.inverse[i]);
    const double near = ((backwards ? box.high[i] : box.low[i]) - beam.p[i]) * beam.inverse[i];
    const double far = ((backwards ? box.low[i] : box.high[i]) - beam.p[i]) * beam.inverse[i];
    if (result.entry < near) result.entry = near;
    if (far < result.exit) result.exit = far;
  }
  return result;
}

}  // namespace durero::accel
