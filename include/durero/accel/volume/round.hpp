#pragma once
/// The round bounding volumes: the ball, and the ellipsoid of revolution, which is a ball of a space that is stretched
/// along one axis.
///
/// A ball is tested as in trace/filter.hpp, one at a time. The ellipsoid |x'| ≤ ρ with x' = x + (λ − 1)(x·d)·d and x =
/// w − centre is tested as a ball against the ray q' + t·v', which is computed in binary64. Λ = max(1, λ) bounds how
/// much lengths grow, κ = Λ/min(1, λ) the ratio of the greatest to the least. So q' errs by less than 2⁻⁴⁸Λ(|p|₁ +
/// |centre|₁), and v' by less than 2⁻⁴⁷κ of its own length; where the ray meets the ellipsoid, t·|v'| ≤ ρ + |q'|, and
/// the point at t is off by no more than 2⁻⁴⁸Λ(|p|₁ + |centre|₁) + 2⁻⁴⁷κ(ρ + 2Λ(|p|₁ + |centre|₁)): a ball whose radius
/// is greater by 2⁻⁴⁵κ(ρ + Λ(|p|₁ + |centre|₁)) contains it.

#include "durero/accel/volume/outline.hpp"
#include "durero/surface/bounds.hpp"
#include "durero/trace/ray.hpp"

namespace durero::accel {

/// The result of testing a ray against a volume.
enum class VolumeTest : std::uint8_t {
  met,     ///< the ray may have a point of the volume up to the limit
  missed,  ///< it has no point of it
  beyond,  ///< it has no point of it up to the limit
};

/// An ellipsoid of revolution: the points w with |x'| ≤ rho, x' as above.
struct Ellipsoid {
  glm::dvec3 centre;  ///< a point of space
  glm::dvec3 axis;    ///< d, a unit vector up to 2⁻⁵⁰
  double lambda;      ///< the factor of lengths along the axis: 2⁻¹⁰ … 2¹⁰
  double rho;         ///< the radius across the axis
};

/// The ellipsoid around an outline, with the proportions of the least one around a cylinder of its measures; around a
/// ball, the ball.
Ellipsoid ellipsoid_around(const Outline& outline);

/// Tests a ray against a ball. Preconditions: the ray is ordinary; the ball is that of an ordinary element.
VolumeTest verdict(const surface::Ball& ball, const trace::Ray& ray, double limit);
/// Tests a ray against an ellipsoid. Preconditions: the ray is ordinary; the ellipsoid is that of an ordinary element.
VolumeTest verdict(const Ellipsoid& ellipsoid, const trace::Ray& ray, double limit);

}  // namespace durero::accel
