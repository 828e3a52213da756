#pragma once
/// Points of shapes under construction (framed_shape.hpp), and directions through them.

#include "conform/framed_shape.hpp"

namespace durero::conform {

/// A point at the given height of an axial shape: part of altura, a multiple of 1/8 (0 the base, 1 the other end). On a
/// sphere and a flat shape, anywhere.
SurfacePoint surface_point_at(Random& random, const FramedShape& shape, double part);
/// Anywhere on it, but at no end of an axial shape and no edge of a flat one.
SurfacePoint surface_point(Random& random, const FramedShape& shape);
/// At a rim, an edge or a vertex where it has one, and not at an apex; on a sphere and a plane, anywhere.
SurfacePoint rim_point(Random& random, const FramedShape& shape);
/// From one end to the other of the generator through the point; 0 where the shape has none.
glm::dvec3 whole_generator(const FramedShape& shape, const SurfacePoint& at);

/// A vector with small integer coordinates for a lattice shape, any direction of that length for a tilted one.
glm::dvec3 any_vector(Random& random, const FramedShape& shape);
/// In the plane that touches there, and not along the generator.
glm::dvec3 tangent_vector(Random& random, const SurfacePoint& at);
/// Across d, exactly where the type has a vector; of a triangle in its plane; of a sphere any.
glm::dvec3 perpendicular_vector(Random& random, const FramedShape& shape);
/// The vector or its opposite: into the shape at that point.
glm::dvec3 inwards(const glm::dvec3& v, const SurfacePoint& at);

}  // namespace durero::conform
