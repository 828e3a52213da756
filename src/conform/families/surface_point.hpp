#pragma once
/// Points of shapes under construction (framed_shape.hpp), and directions through them.

#include "conform/families/framed_shape.hpp"

namespace durero::conform {

/// A point at the height part·altura of an axial shape, for `part` a multiple of 1/8 (0 the base, 1 the other end); on
/// a sphere and a flat shape, any point.
FramedPoint surface_point_at(Random& random, const FramedShape& shape, double part);
/// A point anywhere on the shape, but at no end of an axial shape and at no edge of a flat one.
FramedPoint surface_point(Random& random, const FramedShape& shape);
/// A point at a rim, an edge or a vertex where the shape has one, and never at an apex; on a sphere and a plane, any
/// point.
FramedPoint rim_point(Random& random, const FramedShape& shape);
/// The vector from one end to the other of the generator through the point; 0 where the shape has none.
glm::dvec3 whole_generator(const FramedShape& shape, const FramedPoint& at);

/// A vector with small integer coordinates for a lattice shape, any direction of that length for a tilted one.
glm::dvec3 any_vector(Random& random, const FramedShape& shape);
/// A vector in the tangent plane at the point, and not along the generator.
glm::dvec3 tangent_vector(Random& random, const FramedPoint& at);
/// A vector at right angles to d, exactly where the type has a vector; for a triangle in its plane; for a sphere any.
glm::dvec3 perpendicular_vector(Random& random, const FramedShape& shape);
/// The vector or its opposite, the one that points into the shape at that point.
glm::dvec3 inwards(const glm::dvec3& v, const FramedPoint& at);

}  // namespace durero::conform
