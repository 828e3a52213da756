#pragma once
/// Bounds of the distance of a point from a shape, in binary64: they tell which elements can be the nearest, and how
/// far a ray may go on without passing anything.

#include <limits>

#include "durero/scene/shape_view.hpp"
#include "durero/surface/bounds.hpp"

namespace durero::distance {

/// low ≤ distance ≤ high
struct Bounds {
  double low = 0;                                         ///< not negative
  double high = std::numeric_limits<double>::infinity();  ///< infinite where nothing is known
};

/// The bounds of a shape. They tell nothing where a number of the shape or the point is neither 0 nor of magnitude
/// 2⁻¹⁰⁰ … 2¹⁰⁰.
Bounds bounds(scene::ShapeView shape, const glm::dvec3& p);

/// A number that the distance of the point from a box is not less than.
double least_distance(const surface::Box& box, const glm::dvec3& p);

}  // namespace durero::distance
