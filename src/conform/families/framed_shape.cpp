#include "conform/families/framed_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "conform/families/binary32_axis.hpp"
#include "conform/families/lattice.hpp"
#include "durero/number/dyadic.hpp"
#include "durero/scene/addition.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::conform {
namespace {

using model::Tipo;

/// Sets a frame with d = ±x, ±y or ±z.
void set_lattice_frame(Random& random, FramedShape& shape) {
  const int first = random.integer(0, 2);
  shape.e1 = shape.e2 = shape.d = glm::dvec3(0);
  shape.e1[(first + 1) % 3] = random.sign();
  shape.e2[(first + 2) % 3] = random.sign();
  shape.d[first] = random.sign();
}

/// Sets a frame with any d that Unitario accepts; one in four draws has a coordinate 0.
void set_tilted_frame(Draws& random, FramedShape& shape) {
  do {
    shape.d = random.direction();
    if (random.chance(1, 4)) shape.d[random.integer(0, 2)] = 0;
    shape.d /= std::sqrt(glm::dot(shape.d, shape.d));
  } while (!model::Unitario::contains(model::Vector(shape.d)));
  if (random.rounded(shape.d) != shape.d) shape.d = binary32_axis(shape.d);
  glm::dvec3 e(0);
  e[random.integer(0, 2)] = 1;
  shape.e1 = glm::cross(shape.d, e + 0.25 * random.direction());
  shape.e1 /= std::sqrt(glm::dot(shape.e1, shape.e1));
  shape.e2 = glm::cross(shape.d, shape.e1);
}

template <class Shape>
constexpr bool has_centro = scene::has_attribute<Shape, &scene::AnyEscena::mi_centro>();
template <class Shape>
constexpr bool has_vector = scene::has_attribute<Shape, &scene::AnyEscena::mi_vector>();
template <class Shape>
constexpr bool has_radio = scene::has_attribute<Shape, &scene::AnyEscena::mi_radio>();
template <class Shape>
constexpr bool has_proporcion = scene::has_attribute<Shape, &scene::AnyEscena::mi_proporcion>();
template <class Shape>
constexpr bool has_vertices = scene::has_attribute<Shape, &scene::AnyEscena::mi_vertices>();

FramedShape lattice_triangle(Random& random) {
  for (;;) {
    const double x = random.integer(-300, 300), y = random.integer(-300, 300), z = random.integer(-300, 300);
    const glm::dvec3 a(x, y, z), b = a + 8.0 * random.lattice_vector(12), c = a + 8.0 * random.lattice_vector(12);
    if (are_corners({a, b, c})) return triangle({a, b, c}, true);
  }
}

FramedShape tilted_triangle(Draws& random) {
  for (;;) {
    const glm::dvec3 a = random.in_cube(300), b = a + random.in_cube(100), c = a + random.in_cube(100);
    const scene::Corners vertices = random.rounded(scene::Corners{a, b, c});
    if (are_corners(vertices)) return triangle(vertices, false);
  }
}

bool is_finite(const scene::Corners& of) {
  return std::all_of(of.begin(), of.end(), [](const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  });
}

/// The types for which the condition holds, in their order.
std::vector<Tipo> types_that(bool (*holds)(Tipo)) {
  std::vector<Tipo> types;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    if (holds(Shape::tipo)) types.push_back(Shape::tipo);
  });
  return types;
}

const std::vector<Tipo>& round_types() {
  static const std::vector<Tipo> types = types_that([](Tipo tipo) { return !is_flat(tipo); });
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
    if constexpr (has_centro<Shape>) shape.centro = centro;
    if constexpr (has_radio<Shape>) shape.radio = radio;
    if constexpr (has_proporcion<Shape>) shape.proporcion = proporcion;
    if constexpr (has_vector<Shape>) shape.vector = d;
    if constexpr (surface::Axial<Shape>) shape.altura = altura;
    if constexpr (has_vertices<Shape>) shape.vertices = vertices;
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

Tipo any_type(Draws& random) {
  static const std::vector<Tipo> flat{Tipo::soy_disco, Tipo::soy_triangulo};
  const bool has_round = std::ranges::any_of(round_types(), [&](Tipo tipo) { return random.allows(tipo); });
  return random.any_type_of(has_round ? round_types() : flat);
}

Tipo any_round_type(Draws& random) { return random.any_type_of(round_types()); }

Tipo any_unbounded_type(Draws& random) {
  static const std::vector<Tipo> types{Tipo::soy_plano};
  return random.any_type_of(types);
}

Tipo any_axial_type(Draws& random) {
  static const std::vector<Tipo> types = types_that(is_axial);
  return random.any_type_of(types);
}

bool are_corners(const scene::Corners& vertices) {
  return model::Vertices::contains(scene::input_of<model::Terna>(vertices));
}

FramedShape triangle(const scene::Corners& vertices, bool lattice) {
  FramedShape shape{.tipo = Tipo::soy_triangulo, .lattice = lattice, .vertices = vertices};
  shape.e1 = vertices[1] - vertices[0];
  shape.e2 = vertices[2] - vertices[0];
  shape.d = glm::cross(shape.e1, shape.e2);
  shape.radio = std::max(glm::length(shape.e1), glm::length(shape.e2));
  return shape;
}

FramedShape lattice_shape(Random& random, Tipo tipo) {
  if (tipo == Tipo::soy_triangulo) return lattice_triangle(random);
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

FramedShape tilted_shape(Draws& random, Tipo tipo) {
  if (tipo == Tipo::soy_triangulo) return tilted_triangle(random);
  FramedShape shape{.tipo = tipo, .lattice = false};
  set_tilted_frame(random, shape);
  shape.centro = random.rounded(random.in_cube(300));
  if (has_constant_radius(tipo)) {
    shape.radio = random.rounded(random.uniform(5, 100));
    shape.altura = random.rounded(random.uniform(10, 300));  // of a sphere or a plane it has no meaning
    return shape;
  }
  shape.proporcion = random.rounded(random.uniform(0.2, 4));
  if (random.chance(1, 2))
    shape.altura = std::ldexp(1, random.integer(2, 6));  // the radius of a cone's base is then exact
  else
    shape.altura = random.rounded(random.uniform(5, 100) / shape.proporcion);
  if (!has_apex(tipo)) shape.radio = random.rounded(random.uniform(5, 100));
  return shape;
}

FramedShape any_shape(Draws& random, Tipo tipo) {
  return random.chance(2, 3) ? lattice_shape(random, tipo) : tilted_shape(random, tipo);
}

FramedShape closing_disc(const FramedShape& shape, bool at_base) {
  FramedShape disc = shape;
  disc.tipo = Tipo::soy_disco;
  disc.radio = at_base ? shape.radius() : shape.radio;
  if (!at_base) disc.centro = shape.apex();
  disc.shared.clear();
  return disc;
}

void turn_to(FramedShape& shape, const glm::dvec3& d) {
  shape.d = d;
  shape.e1 -= glm::dot(shape.e1, d) * d;
  shape.e1 /= std::sqrt(glm::dot(shape.e1, shape.e1));
  shape.e2 = glm::cross(d, shape.e1);
}

glm::dvec3 times_power(const glm::dvec3& v, int k) {
  return {std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k)};
}

FramedShape moved(FramedShape shape, const glm::dvec3& by) {
  if (shape.tipo != Tipo::soy_triangulo) {
    shape.centro += by;
    return shape;
  }
  scene::Corners vertices = shape.vertices;
  for (glm::dvec3& vertex : vertices) vertex += by;
  return are_corners(vertices) ? triangle(vertices, shape.lattice) : shape;
}

FramedShape scaled(FramedShape shape, int k) {
  for (glm::dvec3& vertex : shape.vertices) vertex = times_power(vertex, k);
  if (shape.tipo == Tipo::soy_triangulo) return triangle(shape.vertices, shape.lattice);
  shape.centro = times_power(shape.centro, k);
  shape.radio = std::ldexp(shape.radio, k);
  shape.altura = std::ldexp(shape.altura, k);
  shape.shared.clear();
  return shape;
}

std::optional<FramedShape> in_format(const Draws& random, FramedShape shape) {
  if (shape.tipo == Tipo::soy_triangulo) {
    const scene::Corners vertices = random.rounded(shape.vertices);
    if (!is_finite(vertices) || !are_corners(vertices)) return std::nullopt;
    if (vertices == shape.vertices) return shape;
    FramedShape rounded = triangle(vertices, shape.lattice);
    rounded.shared = std::move(shape.shared);
    return rounded;
  }
  shape.centro = random.rounded(shape.centro);
  for (double* length : {&shape.radio, &shape.proporcion, &shape.altura}) *length = random.rounded(*length);
  if (!is_finite({shape.centro, {shape.radio, shape.proporcion, shape.altura}, shape.d})) return std::nullopt;
  if (random.rounded(shape.d) != shape.d) turn_to(shape, binary32_axis(shape.d));
  return shape;
}

}  // namespace durero::conform
