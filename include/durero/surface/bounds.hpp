#pragma once
/// The ball and the box of an element contain its every point. Each is widened by a bound on its own roundings.

#include <glm/vec3.hpp>

namespace durero::surface {

/// The points within a distance of a point.
struct Ball {
  glm::dvec3 centre;  ///< a point of space
  double radius;      ///< infinite where no finite ball contains the element
};

/// The points between two values of each coordinate, both included.
struct Box {
  glm::dvec3 low, high;  ///< corners, infinite where no finite box contains the element
};

// The discs stand across an axis at its two ends, with radii `base` and `top`. Precondition of both functions: every
// number is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰, and the axis is that of a shape.

/// The ball through the rims of both discs; where its centre would lie beyond an end, the ball about that end.
Ball ball_of_discs(const glm::dvec3& centro, const glm::dvec3& vector, double altura, double base, double top);

/// The box of both discs, which contains all points between them.
Box box_of_discs(const glm::dvec3& centro, const glm::dvec3& vector, double altura, double base, double top);

}  // namespace durero::surface
