#include "conform/framed_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "conform/lattice.hpp"
#include "durero/number/dyadic.hpp"
#include "durero/surface/equation.hpp"

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

/// A point at most 2·radio from the middle, and two directions in the plane.
SurfacePoint flat_point(Random& random, const FramedShape& shape) {
  const glm::dvec3 radial = across_axis(random, shape, shape.radio);
  const glm::dvec3 position = shape.centro + double(random.integer(-2, 2)) * radial;
  return {position, shape.d, glm::cross(shape.d, radial), radial};
}

SurfacePoint sphere_point(Random& random, const FramedShape& shape) {
  const glm::dvec3 radial = shape.lattice ? on_sphere(random, shape.radio) : shape.radio * random.direction();
  for (;;) {
    const glm::dvec3 around = glm::cross(radial, random.lattice_vector(2));
    const glm::dvec3 along = glm::cross(radial, random.lattice_vector(2));
    if (around != glm::dvec3(0) && along != glm::dvec3(0)) return {shape.centro + radial, radial, around, along};
  }
}

/// A frame with d = ±x, ±y or ±z.
void set_lattice_frame(Random& random, FramedShape& shape) {
  const int first = random.integer(0, 2);
  shape.e1 = shape.e2 = shape.d = glm::dvec3(0);
  shape.e1[(first + 1) % 3] = random.sign();
  shape.e2[(first + 2) % 3] = random.sign();
  shape.d[first] = random.sign();
}

/// A frame with any d of which Unitario takes; one in four has a coordinate 0.
void set_tilted_frame(Random& random, FramedShape& shape) {
  do {
    shape.d = random.direction();
    if (random.chance(1, 4)) shape.d[random.integer(0, 2)] = 0;
    shape.d /= std::sqrt(glm::dot(shape.d, shape.d));
  } while (!model::Unitario::contains(model::Vector(shape.d)));
  glm::dvec3 e(0);
  e[random.integer(0, 2)] = 1;
  shape.e1 = glm::cross(shape.d, e + 0.25 * random.direction());
  shape.e1 /= std::sqrt(glm::dot(shape.e1, shape.e1));
  shape.e2 = glm::cross(shape.d, shape.e1);
}

template <class Shape>
constexpr bool has_vector = scene::has_attribute<Shape, &model::Escena::mi_vector>();
template <class Shape>
constexpr bool has_radio = scene::has_attribute<Shape, &model::Escena::mi_radio>();
template <class Shape>
constexpr bool has_proporcion = scene::has_attribute<Shape, &model::Escena::mi_proporcion>();

/// The radius of the far end, as a part of that of the base. Precondition: the type has a proportion.
double share_of_far_end(const FramedShape& shape) { return has_apex(shape.tipo) ? 0 : shape.radio / shape.radius(); }

/// The types of which it holds, in their order.
std::vector<Tipo> types_that(bool (*holds)(Tipo)) {
  std::vector<Tipo> types;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    if (holds(Shape::tipo)) types.push_back(Shape::tipo);
  });
  return types;
}

}  // namespace

double FramedShape::radius() const {
  return has_constant_radius(tipo) ? radio : (has_apex(tipo) ? 0 : radio) + proporcion * altura;
}

bool FramedShape::has_exact_radius() const {
  using number::Dyadic;
  if (has_constant_radius(tipo)) return true;
  return Dyadic(has_apex(tipo) ? 0 : radio) + Dyadic(proporcion) * Dyadic(altura) == Dyadic(radius());
}

model::Operation FramedShape::addition(const model::Elemento& e) const {
  return scene::with_shape(tipo, [&]<class Shape>(std::type_identity<Shape>) -> model::Operation {
    Shape shape{};
    shape.centro = centro;
    if constexpr (has_radio<Shape>) shape.radio = radio;
    if constexpr (has_proporcion<Shape>) shape.proporcion = proporcion;
    if constexpr (has_vector<Shape>) shape.vector = d;
    if constexpr (surface::Axial<Shape>) shape.altura = altura;
    return scene::addition(e, shape);
  });
}

bool is_axial(Tipo tipo) {
  return scene::with_shape(tipo, []<class Shape>(std::type_identity<Shape>) { return surface::Axial<Shape>; });
}

bool has_constant_radius(Tipo tipo) {
  return scene::with_shape(tipo, []<class Shape>(std::type_identity<Shape>) { return !has_proporcion<Shape>; });
}

bool has_apex(Tipo tipo) {
  return scene::with_shape(
      tipo, []<class Shape>(std::type_identity<Shape>) { return has_proporcion<Shape> && !has_radio<Shape>; });
}

bool is_flat(Tipo tipo) {
  return scene::with_shape(
      tipo, []<class Shape>(std::type_identity<Shape>) { return has_vector<Shape> && !surface::Axial<Shape>; });
}

Tipo any_type(Random& random) {
  static const std::vector<Tipo> types = types_that([](Tipo tipo) { return !is_flat(tipo); });
  return random.any_of(types);
}

Tipo any_flat_type(Random& random) {
  static const std::vector<Tipo> types = types_that(is_flat);
  return random.any_of(types);
}

Tipo any_axial_type(Random& random) {
  static const std::vector<Tipo> types = types_that(is_axial);
  return random.any_of(types);
}

FramedShape lattice_shape(Random& random, Tipo tipo) {
  FramedShape shape{.tipo = tipo};
  set_lattice_frame(random, shape);
  for (int i = 0; i < 3; ++i) shape.centro[i] = random.integer(-300, 300);
  if (is_flat(tipo)) {
    shape.radio = random.any_of(circle_radii);
    return shape;
  }
  if (!is_axial(tipo)) {
    shape.radio = random.any_of(sphere_radii);
    return shape;
  }
  const double radius = random.any_of(circle_radii);
  if (has_constant_radius(tipo)) {
    shape.radio = radius;
    shape.altura = 8 * random.integer(1, 40);
    return shape;
  }
  shape.proporcion = std::ldexp(1, random.integer(-2, 2));
  if (!has_apex(tipo)) shape.radio = radius / 2;
  shape.altura = (radius - shape.radio) / shape.proporcion;
  return shape;
}

FramedShape tilted_shape(Random& random, Tipo tipo) {
  FramedShape shape{.tipo = tipo, .lattice = false};
  set_tilted_frame(random, shape);
  shape.centro = random.in_cube(300);
  if (has_constant_radius(tipo)) {
    shape.radio = random.uniform(5, 100);
    shape.altura = random.uniform(10, 300);  // of a sphere or a plane it has no meaning
    return shape;
  }
  shape.proporcion = random.uniform(0.2, 4);
  if (random.chance(1, 2))
    shape.altura = std::ldexp(1, random.integer(2, 6));  // the radius of a cone's base is then exact
  else
    shape.altura = random.uniform(5, 100) / shape.proporcion;
  if (!has_apex(tipo)) shape.radio = random.uniform(5, 100);
  return shape;
}

FramedShape any_shape(Random& random, Tipo tipo) {
  return random.chance(2, 3) ? lattice_shape(random, tipo) : tilted_shape(random, tipo);
}

FramedShape scaled(FramedShape shape, int k) {
  for (int i = 0; i < 3; ++i) shape.centro[i] = std::ldexp(shape.centro[i], k);
  shape.radio = std::ldexp(shape.radio, k);
  shape.altura = std::ldexp(shape.altura, k);
  shape.shared.clear();
  return shape;
}

SurfacePoint surface_point_at(Random& random, const FramedShape& shape, double part) {
  if (is_flat(shape.tipo)) return flat_point(random, shape);
  if (!is_axial(shape.tipo)) return sphere_point(random, shape);
  const glm::dvec3 base = across_axis(random, shape, shape.radius()), around = glm::cross(shape.d, base);
  if (has_constant_radius(shape.tipo))
    return {shape.centro + base + part * shape.altura * shape.d, base, around, shape.d};
  const double narrowing = 1 - share_of_far_end(shape);
  const glm::dvec3 along = shape.altura * shape.d - narrowing * base;
  return {shape.centro + base + part * along, (1 - part * narrowing) * base, around, along};
}

SurfacePoint surface_point(Random& random, const FramedShape& shape) {
  if (!is_axial(shape.tipo)) return surface_point_at(random, shape, 0);
  return surface_point_at(random, shape, random.integer(1, 7) / 8.0);
}

SurfacePoint rim_point(Random& random, const FramedShape& shape) {
  const bool has_two_rims = is_axial(shape.tipo) && !has_apex(shape.tipo);
  return surface_point_at(random, shape, has_two_rims ? random.integer(0, 1) : 0);
}

glm::dvec3 whole_generator(const FramedShape& shape, const SurfacePoint& at) {
  if (!is_axial(shape.tipo)) return glm::dvec3(0);
  return has_constant_radius(shape.tipo) ? shape.altura * at.along : at.along;
}

glm::dvec3 any_vector(Random& random, const FramedShape& shape) {
  return shape.lattice ? random.lattice_vector(8) : 8.0 * random.direction();
}

glm::dvec3 tangent_vector(Random& random, const SurfacePoint& at) {
  for (;;) {
    const double around = random.signed_power(0, 2), along = random.integer(-3, 3);
    const glm::dvec3 u = around * at.around + along * at.along;
    if (u != glm::dvec3(0)) return u;
  }
}

glm::dvec3 perpendicular_vector(Random& random, const FramedShape& shape) {
  if (shape.lattice || !is_axial(shape.tipo)) {
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

glm::dvec3 inwards(const glm::dvec3& v, const SurfacePoint& at) {
  const glm::dvec3 normal = glm::cross(at.around, at.along);
  return glm::dot(v, normal) * glm::dot(at.radial, normal) > 0 ? -v : v;
}

}  // namespace durero::conform
