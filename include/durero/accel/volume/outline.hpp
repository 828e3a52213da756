#pragma once
/// The outline of an element is the convex set that a bounding volume must contain: the hull of one to three discs
/// across one axis, or a ball. A sphere is a ball; a cylinder or a cone, whole or truncated, lies between the discs of
/// its ends; a disc is one; a triangle has discs of radius 0 about its vertices.

#include <array>
#include <cmath>
#include <glm/vec3.hpp>

#include "durero/scene/shape_view.hpp"

namespace durero::accel {

/// |x|₁, the sum of the magnitudes of the components.
inline double norm_1(const glm::dvec3& x) { return std::abs(x.x) + std::abs(x.y) + std::abs(x.z); }

/// A slab along a direction n: the points w with low ≤ n·w ≤ high, between two parallel planes.
struct Slab {
  double low, high;  ///< D_min and D_max of Kay and Kajiya, of n·w
};

/// A convex hull of discs, or a ball, that contains an element up to rounding.
struct Outline {
  std::array<glm::dvec3, 3> centre;  ///< of each disc, or of the ball
  std::array<double, 3> radius;      ///< of each disc, or of the ball
  std::size_t count;                 ///< the number of discs; 1 for a ball
  glm::dvec3 axis;                   ///< a unit vector up to 2⁻⁵⁰, perpendicular to the discs; any for a ball
  bool ball;                         ///< whether it is a ball
  double size;  ///< an upper bound of all coordinates, radii and lengths that it is made of: errors are shares of it

  /// The slab along n that contains the hull, widened by a bound on the roundings. Precondition: n is not 0.
  Slab extent(const glm::dvec3& n) const;
  /// The surface of the hull, both sides of a flat one; rounded.
  double surface() const;
  /// The area of the hull's orthogonal projection along a unit vector; rounded.
  double projected(const glm::dvec3& v) const;
};

/// The outline of an element. Precondition: it is trace::ordinary, and no plane.
Outline outline(scene::ShapeView element);

}  // namespace durero::accel
