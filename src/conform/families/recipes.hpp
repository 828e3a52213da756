#pragma once
/// A recipe makes the scenes or the rays of a family; family_table.cpp names them.

#include <span>

#include "conform/families/drawn_ray.hpp"

namespace durero::conform::recipes {

using FramedShapes = std::vector<FramedShape>;
using ShapeSpan = std::span<const FramedShape>;

// Scenes of one to three elements.
FramedShapes some(Draws& random, int);
FramedShapes some_round(Draws& random, int);
FramedShapes some_axial(Draws& random, int);
FramedShapes some_cylinders(Draws& random, int);
FramedShapes some_cones(Draws& random, int);

// Recipes of planes (recipes_flat.cpp).
FramedShapes with_plane(Draws& random, int);
DrawnRay flat(Draws& random, int log2_distance, ShapeSpan shapes);
DrawnRay grazing(Draws& random, int minus_log2_angle, ShapeSpan shapes);

// Recipes of discs (recipes_disc.cpp).
FramedShapes with_disc(Draws& random, int);
DrawnRay disc(Draws& random, int log2_distance, ShapeSpan shapes);
FramedShapes capped(Draws& random, int);
DrawnRay cap(Draws& random, int log2_distance, ShapeSpan shapes);

/// A ray to a solid, given by its wall and then its discs.
DrawnRay solid(Draws& random, ShapeSpan shapes);

// Recipes of triangles (recipes_triangle.cpp).
FramedShapes fan(Draws& random, int);
DrawnRay edge(Draws& random, int log2_distance, ShapeSpan shapes);
FramedShapes closed_mesh(Draws& random, int sides);
DrawnRay vertex(Draws& random, int, ShapeSpan shapes);
FramedShapes sliver(Draws& random, int minus_log2_height);
DrawnRay sliver(Draws& random, int, ShapeSpan shapes);
FramedShapes coplanar(Draws& random, int);
DrawnRay coplanar(Draws& random, int minus_log2_angle, ShapeSpan shapes);

// Recipes of scale (recipes_scale.cpp).
FramedShapes as_many(Draws& random, int count);
DrawnRay generic(Draws& random, int, ShapeSpan shapes);
DrawnRay far_origin(Draws& random, int log2_distance, ShapeSpan shapes);
FramedShapes large_offset(Draws& random, int log2_offset);
FramedShapes scaled_up(Draws& random, int log2_scale);
FramedShapes huge_ratio(Draws& random, int log2_ratio);
DrawnRay near_small(Draws& random, int, ShapeSpan shapes);
DrawnRay direction_scale(Draws& random, int log2_scale, ShapeSpan shapes);
FramedShapes degenerate_numbers(Draws& random, int log2_scale);
DrawnRay degenerate_numbers(Draws& random, int log2_scale, ShapeSpan shapes);
FramedShapes long_thin(Draws& random, int log2_ratio);
DrawnRay long_thin(Draws& random, int log2_ratio, ShapeSpan shapes);
DrawnRay near_origin(Draws& random, int minus_log2_distance, ShapeSpan shapes);
FramedShapes grid(Draws& random, int count);
DrawnRay grid(Draws& random, int, ShapeSpan shapes);

// Recipes of one element near 0, with rays past its bound (recipes_margin.cpp).
FramedShapes bounded(Draws& random, int);
DrawnRay margin(Draws& random, int minus_log2_margin, ShapeSpan shapes);

// Recipes of a whole scene scaled or turned, and of one element twice, nearly (recipes_whole.cpp).
FramedShapes scale(Draws& random, int log2_scale);
DrawnRay scale(Draws& random, int log2_scale, ShapeSpan shapes);
FramedShapes rotation(Draws& random, int tangent_in_64ths);
FramedShapes parked(Draws& random, int units);

// Recipes of direction (recipes_direction.cpp).
FramedShapes near_axial(Draws& random, int);
DrawnRay near_axial(Draws& random, int minus_log2_slope, ShapeSpan shapes);
DrawnRay perpendicular(Draws& random, int log2_distance, ShapeSpan shapes);
DrawnRay near_generator(Draws& random, int minus_log2_least_angle, ShapeSpan shapes);
DrawnRay second_nappe(Draws& random, int eighths, ShapeSpan shapes);
DrawnRay axis_parallel(Draws& random, int log2_distance, ShapeSpan shapes);
DrawnRay in_surface(Draws& random, int eighths, ShapeSpan shapes);

// Recipes of the place of the point (recipes_place.cpp).
DrawnRay apex(Draws& random, int log2_distance, ShapeSpan shapes);
FramedShapes rim(Draws& random, int);
DrawnRay rim(Draws& random, int log2_distance, ShapeSpan shapes);
DrawnRay inside(Draws& random, int quarters, ShapeSpan shapes);
FramedShapes with_twin(Draws& random, int);
DrawnRay on_surface(Draws& random, int percent, ShapeSpan shapes);
FramedShapes tangent(Draws& random, int);
DrawnRay tangent(Draws& random, int log2_distance, ShapeSpan shapes);
DrawnRay zero_b(Draws& random, int percent, ShapeSpan shapes);
FramedShapes tie(Draws& random, int);
DrawnRay tie(Draws& random, int log2_distance, ShapeSpan shapes);

}  // namespace durero::conform::recipes
