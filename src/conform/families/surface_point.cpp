#include "conform/families/surface_point.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "conform/families/lattice.hpp"
#include "durero/scene/attributes.hpp"

namespace durero::conform {
namespace {

using model::Tipo;

glm::dvec3 across_axis(Random& random, const FramedShape& shape, double radius) {
  if (shape.lattice) {
    const glm::dvec2 p = on_circle(random, radius);
    return p.x * shape.e1 + p.y * shape.e2;
  }
  for (;;) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), length = std::sqrt(x * x + y * y);
    if (length > 0.1 && length <= 1) return radius * (x / length * shape.e1 + y / length * shape.e2);
  }
}

FramedPoint triangle_point(Random& random, const FramedShape& shape) {
  const int i = random.integer(1, 6), j = random.integer(1, 7 - i);
  return {shape.vertices[0] + i / 8.0 * shape.e1 + j / 8.0 * shape.e2, shape.d, shape.e1, shape.e2};
}

/// A vertex, or a point between two.
FramedPoint edge_point(Random& random, const FramedShape& shape) {
  const std::size_t i = random.below(3);
  const double part = random.integer(0, 7) / 8.0;
  const glm::dvec3 &from = shape.vertices[i], &to = shape.vertices[(i + 1) % 3];
  return {from + part * (to - from), shape.d, shape.e1, shape.e2};
}

/// A point at most `greatest` times radio from the middle, in steps of that part of it, and two directions in the
/// plane.
FramedPoint point_around(Random& random, const FramedShape& shape, int least, int greatest, double part) {
  const glm::dvec3 radial = across_axis(random, shape, shape.radio);
  const glm::dvec3 position = shape.centro + part * random.integer(least, greatest) * radial;
  return {position, shape.d, glm::cross(shape.d, radial), radial};
}

FramedPoint flat_point(Random& random, const FramedShape& shape) {
  if (shape.tipo == Tipo::soy_triangulo) return triangle_point(random, shape);
  if (shape.tipo == Tipo::soy_disco) return point_around(random, shape, -7, 7, 1.0 / 8);
  return point_around(random, shape, -2, 2, 1);
}

FramedPoint sphere_point(Random& random, const FramedShape& shape) {
  const glm::dvec3 radial = shape.lattice ? on_sphere(random, shape.radio) : shape.radio * random.direction();
  for (;;) {
    const glm::dvec3 around = glm::cross(radial, random.lattice_vector(2));
    const glm::dvec3 along = glm::cross(radial, random.lattice_vector(2));
    if (around != glm::dvec3(0) && along != glm::dvec3(0)) return {shape.centro + radial, radial, around, along};
  }
}

/// Whether e1 and e2 are at right angles to d only up to roundings.
bool has_rounded_frame(const FramedShape& shape) {
  return !shape.lattice && scene::with_shape(shape.tipo, []<class Shape>(std::type_identity<Shape>) {
    return scene::has_attribute<Shape, &scene::AnyEscena::mi_vector>();
  });
}

/// The radius of the far end over that of the base. Precondition: the type has a proportion.
double share_of_far_end(const FramedShape& shape) { return has_apex(shape.tipo) ? 0 : shape.radio / shape.radius(); }

}  // namespace

FramedPoint surface_point_at(Random& random, const FramedShape& shape, double part) {
  if (is_flat(shape.tipo)) return flat_point(random, shape);
  if (!is_axial(shape.tipo)) return sphere_point(random, shape);
  const glm::dvec3 base = across_axis(random, shape, shape.radius()), around = glm::cross(shape.d, base);
  if (has_constant_radius(shape.tipo))
    return {shape.centro + base + part * shape.altura * shape.d, base, around, shape.d};
  const double narrowing = 1 - share_of_far_end(shape);
  const glm::dvec3 along = shape.altura * shape.d - narrowing * base;
  return {shape.centro + base + part * along, (1 - part * narrowing) * base, around, along};
}

FramedPoint surface_point(Random& random, const FramedShape& shape) {
  if (!is_axial(shape.tipo)) return surface_point_at(random, shape, 0);
  return surface_point_at(random, shape, random.integer(1, 7) / 8.0);
}

FramedPoint rim_point(Random& random, const FramedShape& shape) {
  if (shape.tipo == Tipo::soy_triangulo) return edge_point(random, shape);
  if (shape.tipo == Tipo::soy_disco) return point_around(random, shape, 1, 1, 1);
  const bool has_two_rims = is_axial(shape.tipo) && !has_apex(shape.tipo);
  return surface_point_at(random, shape, has_two_rims ? random.integer(0, 1) : 0);
}

glm::dvec3 whole_generator(const FramedShape& shape, const FramedPoint& at) {
  if (!is_axial(shape.tipo)) return glm::dvec3(0);
  return has_constant_radius(shape.tipo) ? shape.altura * at.along : at.along;
}

glm::dvec3 any_vector(Random& random, const FramedShape& shape) {
  return shape.lattice ? random.lattice_vector(8) : 8.0 * random.direction();
}

glm::dvec3 tangent_vector(Random& random, const FramedPoint& at) {
  for (;;) {
    const double around = random.signed_power(0, 2), along = random.integer(-3, 3);
    const glm::dvec3 u = around * at.around + along * at.along;
    if (u != glm::dvec3(0)) return u;
  }
}

glm::dvec3 perpendicular_vector(Random& random, const FramedShape& shape) {
  if (!has_rounded_frame(shape)) {
    for (;;) {
      const double x = random.integer(-8, 8), y = random.integer(-8, 8);
      const glm::dvec3 w = x * shape.e1 + y * shape.e2;
      if (w != glm::dvec3(0)) return w;
    }
  }
  // (−d.y, d.x, 0) and its like: the two products of its product with d are opposite, whatever d.
  for (;;) {
    const int i = random.integer(0, 2), j = (i + 1) % 3;
    glm::dvec3 w(0);
    w[i] = -shape.d[j];
    w[j] = shape.d[i];
    if (w != glm::dvec3(0)) return random.sign() * w;
  }
}

glm::dvec3 inwards(const glm::dvec3& v, const FramedPoint& at) {
  const glm::dvec3 normal = glm::cross(at.around, at.along);
  return glm::dot(v, normal) * glm::dot(at.radial, normal) > 0 ? -v : v;
}

}  // namespace durero::conform
