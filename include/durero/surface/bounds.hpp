#pragma once
/// What contains every point of an element: a ball, and a box along the axes of space. Each is wider than the exact one
/// by what its own roundings may be.

#include <glm/vec3.hpp>

namespace durero::surface {

/// The points within a distance of a point.
struct Ball {
  glm::dvec3 centre;  ///< a point of space
  double radius;      ///< infinite where nothing less contains the element
};

/// The points between two values of each coordinate.
struct Box {
  glm::dvec3 low, high;  ///< corners, infinite where nothing less contains the element
};

// Of a shape along an axis, by the discs across it at its two ends, of these radii. Precondition of both: every number
// is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰, and the axis that of a shape.

/// The ball through the rims of both discs; where its centre would lie beyond an end, the ball about that end.
Ball ball_of_discs(const glm::dvec3& centro, const glm::dvec3& vector, double altura, double base, double top);

/// The box of both discs, and so of all between them.
Box box_of_discs(const glm::dvec3& centro, const glm::dvec3& vector, double altura, double base, double top);

}  // namespace durero::surface
