#include <cmath>
#include <utility>

#include "conform/families/recipes.hpp"

namespace durero::conform::recipes {
namespace {

using model::Tipo;

template <class Type>
FramedShapes one_to_three(Draws& random, Type type) {
  FramedShapes shapes(random.below(3) + 1);
  for (FramedShape& shape : shapes) shape = any_shape(random, type(random));
  return shapes;
}

/// An ordinary ray at any scale: it is made at a moderate scale, where no product overflows, and then scaled.
DrawnRay ordinary_scaled(Draws& random, const FramedShape& shape, int k, int e) {
  return scaled(ordinary(random, scaled(shape, -k), e), k);
}

double quarters(Draws& random, int half) { return random.integer(-4 * half, 4 * half) / 4.0; }

glm::dvec3 on_grid(Draws& random, int half) {
  const double x = quarters(random, half), y = quarters(random, half), z = quarters(random, half);
  return {x, y, z};
}

FramedShape triangle_on_grid(Draws& random) {
  for (;;) {
    const glm::dvec3 a = on_grid(random, 3), b = on_grid(random, 3), c = on_grid(random, 3);
    if (are_corners({a, b, c})) return triangle({a, b, c}, true);
  }
}

}  // namespace

FramedShapes some(Draws& random, int) { return one_to_three(random, any_type); }
FramedShapes some_round(Draws& random, int) { return one_to_three(random, any_round_type); }
FramedShapes some_axial(Draws& random, int) { return one_to_three(random, any_axial_type); }
FramedShapes some_cylinders(Draws& random, int) {
  return one_to_three(random, [](Draws&) { return Tipo::soy_cilindro; });
}
FramedShapes some_cones(Draws& random, int) {
  return one_to_three(random, [](Draws&) { return Tipo::soy_cono; });
}

FramedShapes as_many(Draws& random, int count) {
  FramedShapes shapes(static_cast<std::size_t>(count));
  for (FramedShape& shape : shapes) shape = any_shape(random, any_type(random));
  return shapes;
}

DrawnRay generic(Draws& random, int, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes);
  return ordinary(random, shape, random.integer(0, 4));
}

DrawnRay far_origin(Draws& random, int log2_distance, ShapeSpan shapes) {
  return ordinary(random, random.any_of(shapes), log2_distance);
}

FramedShapes large_offset(Draws& random, int log2_offset) {
  FramedShapes shapes = some(random, 0);
  // The farthest coordinate of each centre is at least 2^(log2_offset + 8) less the 300 of its place in the scene.
  const glm::dvec3 offset = std::ldexp(1, log2_offset + 8) * random.lattice_vector(4);
  for (FramedShape& shape : shapes) shape = moved(std::move(shape), offset);
  return shapes;
}

FramedShapes scaled_up(Draws& random, int log2_scale) {
  FramedShapes shapes = some(random, 0);
  for (FramedShape& shape : shapes) shape = scaled(shape, log2_scale);
  return shapes;
}

FramedShapes huge_ratio(Draws& random, int log2_ratio) {
  FramedShapes shapes = some(random, 0);
  // A great element that passes by the small ones: a point of its surface is near their place.
  FramedShape great = scaled(any_shape(random, any_type(random)), log2_ratio);
  great.centro = glm::dvec3(0);
  const FramedPoint near = surface_point(random, great);
  shapes.push_back(moved(std::move(great), 32.0 * random.lattice_vector(16) - near.position));
  return shapes;
}

DrawnRay near_small(Draws& random, int, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes.first(shapes.size() - 1));
  return ordinary(random, shape, random.integer(0, 3));
}

DrawnRay direction_scale(Draws& random, int log2_scale, ShapeSpan shapes) {
  DrawnRay ray = generic(random, 0, shapes);
  ray.v *= std::ldexp(1, log2_scale);
  return ray;
}

FramedShapes degenerate_numbers(Draws& random, int log2_scale) { return scaled_up(random, log2_scale); }

DrawnRay degenerate_numbers(Draws& random, int log2_scale, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes);
  DrawnRay ray = ordinary_scaled(random, shape, log2_scale, random.integer(0, 4));
  if (random.chance(1, 2)) return ray;
  // A direction of another scale: t itself may be subnormal or overflow.
  const int least = random.least_exponent(), end = random.end_of_exponents();
  const int k = random.integer(least, end - 14) - log2_scale;
  for (int i = 0; i < 3; ++i) ray.v[i] = std::ldexp(ray.v[i], k);
  return ray;
}

FramedShapes long_thin(Draws& random, int log2_ratio) {
  FramedShapes shapes = some_axial(random, 0);
  for (FramedShape& shape : shapes) {
    // The radius here is the part by which the shape narrows; a lattice shape with that part as proporcion·altura keeps
    // its radii.
    const bool has_top = !has_constant_radius(shape.tipo) && !has_apex(shape.tipo);
    const double radius = shape.radius() - (has_top ? shape.radio : 0);
    shape.altura = std::ldexp(shape.lattice ? radius : std::ldexp(1, std::ilogb(radius) + 1), log2_ratio);
    shape.proporcion = std::ldexp(1, -log2_ratio);
  }
  return shapes;
}

DrawnRay long_thin(Draws& random, int log2_ratio, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes);
  return ordinary(random, shape, random.integer(0, log2_ratio));
}

DrawnRay near_origin(Draws& random, int minus_log2_distance, ShapeSpan shapes) {
  return ordinary(random, random.any_of(shapes), -minus_log2_distance);
}

FramedShapes grid(Draws& random, int count) {
  FramedShapes shapes(static_cast<std::size_t>(count));
  for (FramedShape& shape : shapes) {
    shape = lattice_shape(random, any_type(random));
    if (shape.tipo == Tipo::soy_triangulo) {
      shape = triangle_on_grid(random);
      continue;
    }
    shape.centro = on_grid(random, 3);
    shape.radio = shape.proporcion = random.integer(1, 8) / 4.0;
    shape.altura = random.integer(1, 16) / 4.0;
  }
  return shapes;
}

DrawnRay grid(Draws& random, int, ShapeSpan) {
  const glm::dvec3 p = on_grid(random, 5);
  const double power = random.signed_power(-2, 1);
  return {p, power * random.lattice_vector(4)};
}

}  // namespace durero::conform::recipes
