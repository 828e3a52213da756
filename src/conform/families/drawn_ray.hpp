#pragma once
/// A drawn ray is a ray under construction. It goes through a point of a shape (surface_point.hpp), with or without a
/// coincidence.

#include <vector>

#include "conform/families/draws.hpp"
#include "conform/families/surface_point.hpp"

namespace durero::conform {

/// A ray p + t·v as it was drawn: it need not be finite, nor v other than 0. `on` holds the places of the shapes that p
/// lies on.
struct DrawnRay {
  glm::dvec3 p, v;
  std::vector<std::size_t> on{};
};

/// The ray with all lengths times 2^k.
DrawnRay scaled(DrawnRay ray, int k);

/// The ray that reaches the point along w from m·w before it; its v is w times a random power of two in 2⁻³ … 2³.
DrawnRay arriving(Draws& random, const glm::dvec3& point, const glm::dvec3& w, double m);
/// The power of two that makes m·|w| about 2^e times the length. Precondition: w ≠ 0.
double steps(const glm::dvec3& w, double length, int e);

/// The ray with one coordinate of p or of v replaced by the next number after or before it; one in two coordinates that
/// are 0 stays.
DrawnRay nudged(Draws& random, DrawnRay ray);
DrawnRay one_in_three_nudged(Draws& random, DrawnRay ray);

/// A ray with a coincidence, which is exact where the shape is a lattice one: tangent, through a rim or the apex,
/// across the axis, or along a generator's direction. It starts about 2^e radii before the point.
DrawnRay coincident(Draws& random, const FramedShape& shape, int e);
/// A ray that is coincident in one of three cases, and otherwise goes through a point of the surface in any direction,
/// mostly into the shape.
DrawnRay ordinary(Draws& random, const FramedShape& shape, int e);

}  // namespace durero::conform
