#pragma once
/// Directions from a point: cones of them, and balls as they are seen. What is asked of both is answered in binary64
/// with a bound on its error, always to the side that costs time and no answer.

#include <glm/vec3.hpp>

#include "durero/surface/bounds.hpp"

namespace durero::accel {

/// The directions within an angle of an axis, up to 90°.
struct Cone {
  glm::dvec3 axis;  ///< of length 1 up to 8u
  double cosine;    ///< of the angle
  double sine;      ///< of the angle
};

/// The cone about an axis of any length whose angle has this cosine or a greater one, and is wider by `more` (radians).
/// Precondition: the cosine is not below `more`.
Cone cone(const glm::dvec3& axis, double cosine, double more);

/// The cosine of the angle between two directions of length 1, up to the rounding that `angle_slack` pays for.
double cosine_between(const glm::dvec3& a, const glm::dvec3& b);
/// The direction of a vector, its length 1 up to 8u. Precondition: its components are 0 or of magnitude 2⁻¹⁶⁰ … 2¹²⁰,
/// and not all 0.
glm::dvec3 direction(const glm::dvec3& vector);

/// A ball as it is seen from a point.
struct Seen {
  bool around;         ///< the point may lie in the ball, or the ball is infinite: it is seen in every direction
  glm::dvec3 towards;  ///< the direction of its centre
  double cosine;       ///< of the angle between that and its edge, which is not less than the exact one
  double sine;         ///< of that angle
  double distance;     ///< of its centre, up to 8u of it
  double near;         ///< no point of the ball is nearer
  double far;          ///< no point of the ball is farther
};

/// Preconditions: the components of the point and of the centre are 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰.
Seen seen(const surface::Ball& ball, const glm::dvec3& from);

/// False only where no direction of the cone is that of a point of the ball.
bool may_be_seen(const Seen& ball, const Cone& cone);

/// True only where every direction of the cone is within the angle of this sine, up to 1, of the ball's centre.
bool is_covered(const Cone& cone, const Seen& ball, double sine);

}  // namespace durero::accel
