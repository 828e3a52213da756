#pragma once
/// Directions from a point: cones of directions, and balls seen from the point. The tests of both compute in binary64
/// with a bound on the error, and err only to the side that costs time and no answer.

#include <glm/vec3.hpp>

#include "durero/surface/bounds.hpp"

namespace durero::accel {

/// A cone: the directions within an angle of an axis, up to 90°.
struct DirectionCone {
  glm::dvec3 axis;  ///< of length 1 up to 8u
  double cosine;    ///< of the angle
  double sine;      ///< of the angle
};

/// The cone about an axis of any length whose angle has this cosine or a greater one, widened by `more` radians.
/// Precondition: the cosine is not below `more`.
DirectionCone cone(const glm::dvec3& axis, double cosine, double more);

/// The cosine of the angle between two directions of length 1, up to the rounding that `angle_slack` pays for.
double cosine_between(const glm::dvec3& a, const glm::dvec3& b);
/// The direction of a vector, of length 1 up to 8u. Precondition: the components are 0 or of magnitude 2⁻¹⁶⁰ … 2¹²⁰,
/// and not all 0.
glm::dvec3 direction(const glm::dvec3& vector);

/// A ball, seen from a point.
struct ApparentBall {
  bool around;         ///< the point may lie in the ball, or the ball is infinite: it is seen in every direction
  glm::dvec3 towards;  ///< the direction of its centre
  double cosine;       ///< of the angle from the centre to the edge, which is not less than the exact one
  double sine;         ///< of that angle
  double distance;     ///< of the centre, up to 8u of it
  double near;         ///< a lower bound of the distance of its points
  double far;          ///< an upper bound of the distance of its points
};

/// The ball seen from a point. Preconditions: the components of the point and of the centre are 0 or of magnitude 2⁻¹⁰⁰
/// … 2¹⁰⁰.
ApparentBall seen(const surface::Ball& ball, const glm::dvec3& from);

/// Whether some point of the ball may be seen in a direction of the cone; false only where none is.
bool may_be_seen(const ApparentBall& ball, const DirectionCone& cone);

/// Whether every direction of the cone is within an angle of the ball's centre, whose sine is `sine` ≤ 1; true only
/// where it is.
bool is_covered(const DirectionCone& cone, const ApparentBall& ball, double sine);

}  // namespace durero::accel
