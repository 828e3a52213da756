#include <cmath>

#include "conform/families/recipes.hpp"

namespace durero::conform::recipes {
namespace {

/// A ray along the axis, with p before, beside or after the element: in its surface, inside or outside it.
DrawnRay parallel(Draws& random, const FramedShape& shape) {
  const FramedPoint at = surface_point(random, shape);
  const glm::dvec3 aside = (random.integer(-2, 8) / 8.0) * at.radial;  // of the way to the axis
  const glm::dvec3 from = random.chance(1, 2) ? at.position : at.position - aside;
  const double back = shape.altura * (random.integer(-8, 16) / 8.0);
  const DrawnRay ray{from - back * shape.d, random.signed_power(-3, 3) * shape.d};
  return random.chance(1, 3) ? nudged(random, ray) : ray;
}

}  // namespace

FramedShapes near_axial(Draws& random, int) {
  FramedShapes shapes = some_cylinders(random, 0);
  for (FramedShape& shape : shapes) {
    // Long enough that even a ray parallel to a tilted axis, of length 1 up to 2⁻⁵⁰, meets it.
    if (!shape.lattice && random.chance(1, 3)) shape.altura = std::ldexp(shape.altura, random.integer(40, 60));
  }
  return shapes;
}

DrawnRay near_axial(Draws& random, int minus_log2_slope, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes);
  if (random.chance(1, 3)) return parallel(random, shape);
  const FramedPoint at = surface_point(random, shape);
  const double slope = random.sign() * std::ldexp(1, -minus_log2_slope - std::ilogb(shape.radio) - 1);
  const glm::dvec3 w = random.sign() * (shape.d + slope * at.radial);
  return arriving(random, at.position, w, std::ldexp(1, random.integer(-2, 12)));
}

DrawnRay perpendicular(Draws& random, int log2_distance, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes);
  const FramedPoint at = random.chance(1, 3) ? rim_point(random, shape) : surface_point(random, shape);
  glm::dvec3 w = perpendicular_vector(random, shape);
  if (random.chance(3, 4)) w = inwards(w, at);
  return arriving(random, at.position, w, steps(w, shape.radius(), log2_distance));
}

DrawnRay near_generator(Draws& random, int minus_log2_least_angle, ShapeSpan shapes) {
  // A nearly linear quadratic loses digits of its root, up to the angle at which a program takes it for linear: between
  // 2⁻⁹ and 2⁻²⁹ in the programs that were seen. Each ray has an angle of its own, so that few scenes have them all.
  constexpr int minus_log2_greatest_angle = 6;
  const FramedShape& shape = random.any_of(shapes);
  const FramedPoint at = surface_point(random, shape);
  glm::dvec3 w = random.sign() * at.along;
  if (random.chance(1, 2)) {
    const int minus_log2_angle = random.integer(minus_log2_greatest_angle, minus_log2_least_angle);
    w += std::ldexp(1, -minus_log2_angle) * any_vector(random, shape);
  }
  const glm::dvec3 through = random.chance(7, 8) ? surface_point(random, shape).position : at.position;
  return arriving(random, through, w, steps(w, shape.radius(), random.integer(-1, 5)));
}

DrawnRay second_nappe(Draws& random, int eighths, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes);
  const FramedPoint mirrored = surface_point_at(random, shape, 1 + eighths / 8.0);
  const bool never_real = random.chance(1, 4);
  const FramedPoint real = random.chance(1, 3) ? rim_point(random, shape) : surface_point(random, shape);
  const glm::dvec3 to =
      never_real ? surface_point_at(random, shape, 1 + random.integer(1, 8) / 8.0).position : real.position;
  return arriving(random, mirrored.position, to - mirrored.position, std::ldexp(1, random.integer(-3, 3)));
}

DrawnRay axis_parallel(Draws& random, int log2_distance, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes);
  const FramedPoint at = random.chance(1, 2) ? rim_point(random, shape) : surface_point(random, shape);
  const int axis = random.integer(0, 2);
  glm::dvec3 w(0);
  w[axis] = random.sign();
  if (random.chance(1, 3)) w[(axis + random.integer(1, 2)) % 3] = random.integer(-4, 4);
  if (random.chance(3, 4)) w = inwards(w, at);
  DrawnRay ray = arriving(random, at.position, w, steps(w, shape.radius(), log2_distance));
  for (int i = 0; i < 3; ++i) {
    if (ray.v[i] != 0 || random.chance(1, 3)) continue;
    const int least = random.least_exponent(), digits = random.digits();
    const double tiny = std::ldexp(1, least + random.integer(0, digits - 2));
    const double magnitude = random.chance(1, 2) ? 0 : tiny;
    ray.v[i] = random.sign() * magnitude;
  }
  return ray;
}

DrawnRay in_surface(Draws& random, int eighths, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes);
  const double part = random.integer(0, 8) / 8.0;
  const FramedPoint at = surface_point_at(random, shape, part);
  const glm::dvec3 whole = whole_generator(shape, at);
  const double by = random.sign() * eighths / 8.0;
  DrawnRay ray{at.position + by * whole, random.signed_power(-3, 3) * whole};
  const bool named = shape.lattice && part + by >= 0 && part + by <= 1 && random.chance(1, 3);
  if (named) ray.on.push_back(static_cast<std::size_t>(&shape - shapes.data()));
  return !named && random.chance(1, 4) ? nudged(random, ray) : ray;
}

}  // namespace durero::conform::recipes
