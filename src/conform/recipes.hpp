#pragma once
/// How the scenes and the rays of each family are made; family_table.cpp names them.

#include <span>

#include "conform/drawn_ray.hpp"

namespace durero::conform::recipes {

using FramedShapes = std::vector<FramedShape>;
using Given = std::span<const FramedShape>;

// Scenes of one to three elements.
FramedShapes some(Random& random, int);
FramedShapes some_axial(Random& random, int);
FramedShapes some_cylinders(Random& random, int);
FramedShapes some_cones(Random& random, int);

// Of planes (recipes_flat.cpp).
FramedShapes with_plane(Random& random, int);
DrawnRay flat(Random& random, int log2_distance, Given shapes);
DrawnRay grazing(Random& random, int minus_log2_angle, Given shapes);

// Of discs (recipes_disc.cpp).
FramedShapes with_disc(Random& random, int);
DrawnRay disc(Random& random, int log2_distance, Given shapes);
FramedShapes capped(Random& random, int);
DrawnRay cap(Random& random, int log2_distance, Given shapes);

// Of triangles (recipes_triangle.cpp).
FramedShapes fan(Random& random, int);
DrawnRay edge(Random& random, int log2_distance, Given shapes);
FramedShapes sliver(Random& random, int minus_log2_height);
DrawnRay sliver(Random& random, int, Given shapes);
FramedShapes coplanar(Random& random, int);
DrawnRay coplanar(Random& random, int minus_log2_angle, Given shapes);

// Of scale (recipes_scale.cpp).
FramedShapes as_many(Random& random, int count);
DrawnRay generic(Random& random, int, Given shapes);
DrawnRay far_origin(Random& random, int log2_distance, Given shapes);
FramedShapes large_offset(Random& random, int log2_offset);
FramedShapes scaled_up(Random& random, int log2_scale);
FramedShapes huge_ratio(Random& random, int log2_ratio);
DrawnRay near_small(Random& random, int, Given shapes);
DrawnRay direction_scale(Random& random, int log2_scale, Given shapes);
FramedShapes degenerate_numbers(Random& random, int log2_scale);
DrawnRay degenerate_numbers(Random& random, int log2_scale, Given shapes);
FramedShapes long_thin(Random& random, int log2_ratio);
DrawnRay long_thin(Random& random, int log2_ratio, Given shapes);
DrawnRay near_origin(Random& random, int minus_log2_distance, Given shapes);
FramedShapes grid(Random& random, int count);
DrawnRay grid(Random& random, int, Given shapes);

// Of direction (recipes_direction.cpp).
FramedShapes near_axial(Random& random, int);
DrawnRay near_axial(Random& random, int minus_log2_slope, Given shapes);
DrawnRay perpendicular(Random& random, int log2_distance, Given shapes);
DrawnRay near_generator(Random& random, int minus_log2_angle, Given shapes);
DrawnRay second_nappe(Random& random, int eighths, Given shapes);
DrawnRay axis_parallel(Random& random, int log2_distance, Given shapes);
DrawnRay in_surface(Random& random, int eighths, Given shapes);

// Of the place of the point (recipes_place.cpp).
DrawnRay apex(Random& random, int log2_distance, Given shapes);
FramedShapes rim(Random& random, int);
DrawnRay rim(Random& random, int log2_distance, Given shapes);
DrawnRay inside(Random& random, int quarters, Given shapes);
FramedShapes with_twin(Random& random, int);
DrawnRay on_surface(Random& random, int percent, Given shapes);
FramedShapes tangent(Random& random, int);
DrawnRay tangent(Random& random, int log2_distance, Given shapes);
DrawnRay zero_b(Random& random, int percent, Given shapes);
FramedShapes tie(Random& random, int);
DrawnRay tie(Random& random, int log2_distance, Given shapes);

}  // namespace durero::conform::recipes
