#pragma once
/// What a bounding volume must contain of an element: the convex hull of one to three points with a disc across one
/// axis about each, or of a ball. A sphere is a ball; a cylinder or a cone, whole or truncated, lies between the discs
/// of its ends; a disc is one; a triangle has discs of radius 0 about its vertices.

#include <array>
#include <cmath>
#include <glm/vec3.hpp>

#include "durero/scene/shape_view.hpp"

namespace durero::accel {

/// |x|₁, the sum of the magnitudes of its components.
inline double norm_1(const glm::dvec3& x) { return std::abs(x.x) + std::abs(x.y) + std::abs(x.z); }

/// From low to high along a direction n: the points w with low ≤ n·w ≤ high lie between two parallel planes.
struct Slab {
  double low, high;  ///< D_min and D_max of Kay and Kajiya, of n·w
};

/// The points that an element lies between, up to rounding.
struct Outline {
  std::array<glm::dvec3, 3> centre;  ///< of each disc, or of the ball
  std::array<double, 3> radius;      ///< of each
  std::size_t count;                 ///< how many
  glm::dvec3 axis;                   ///< across which they lie: a unit vector up to 2⁻⁵⁰; of a ball any
  bool ball;                         ///< a ball, and no disc
  double size;  ///< no less than any coordinate, radius or length that went into it: errors are shares of it

  /// The extent along n, any vector that is not 0, wider than the exact one by what rounding may change.
  Slab extent(const glm::dvec3& n) const;
  /// The surface of the hull, both sides of a flat one; rounded.
  double surface() const;
  /// The area of its orthogonal projection along a unit vector; rounded.
  double projected(const glm::dvec3& v) const;
};

/// Of an element. Precondition: it is trace::ordinary, and no plane.
Outline outline(scene::ShapeView element);

}  // namespace durero::accel
