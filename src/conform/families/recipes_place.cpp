#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "conform/families/recipes.hpp"
#include "durero/contract/contract.hpp"

namespace durero::conform::recipes {
namespace {

using model::Tipo;

/// The index of the coordinate of d with the greatest magnitude.
int longest(const glm::dvec3& d) {
  const glm::dvec3 a(std::abs(d.x), std::abs(d.y), std::abs(d.z));
  return a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
}

/// A vector exactly at right angles to d, with the coordinate i = 0: the two products of its product with d are
/// opposite.
glm::dvec3 across(const glm::dvec3& d, int i) {
  glm::dvec3 u(0);
  u[(i + 1) % 3] = -d[(i + 2) % 3];
  u[(i + 2) % 3] = d[(i + 1) % 3];
  return u;
}

/// A tilted cylinder at 0 whose altura is avance of the point 2^k on a coordinate axis: rays across the axis through
/// that point stay in the plane of the rim, though the axis is no exact unit vector.
FramedShape tilted_with_exact_rims(Draws& random) {
  FramedShape shape = tilted_shape(random, Tipo::soy_cilindro);
  const int k = random.integer(2, 6);
  shape.centro = glm::dvec3(0);
  shape.altura = std::ldexp(std::abs(shape.d[longest(shape.d)]), k);
  shape.radio = std::ldexp(random.uniform(0.9, 1.5), k);
  return shape;
}

/// A ray in the plane of a rim of such a cylinder. Precondition: centro = 0.
DrawnRay in_plane_of_rim(Draws& random, const FramedShape& shape) {
  const int i = longest(shape.d);
  glm::dvec3 p(0);
  if (random.chance(1, 2)) p[i] = shape.altura / shape.d[i];
  const glm::dvec3 u = random.sign() * across(shape.d, i);
  if (u == glm::dvec3(0)) return {p, {1, 0, 0}};
  return {p + steps(u, shape.radius(), 3) * u, std::ldexp(-1, random.integer(-3, 3)) * u};
}

/// A tangent at the base of a tilted element at 0 whose axis has a coordinate 0: across the axis, in the plane of the
/// base, at the point `radius` along that coordinate's axis.
std::optional<DrawnRay> tangent_to_tilted(Draws& random, const FramedShape& shape) {
  if (shape.lattice || shape.centro != glm::dvec3(0) || !is_axial(shape.tipo)) return std::nullopt;
  const double radius = shape.radius();
  if (!shape.has_exact_radius()) return std::nullopt;
  for (int i = 0; i < 3; ++i) {
    if (shape.d[i] != 0) continue;
    glm::dvec3 point(0);
    point[i] = random.sign() * radius;
    const glm::dvec3 u = random.sign() * across(shape.d, i);
    return arriving(random, point, u, steps(u, radius, random.integer(0, 8)));
  }
  return std::nullopt;
}

glm::dvec3 entering_both(Draws& random, const FramedShape& shape, const FramedPoint& one, const FramedPoint& other) {
  glm::dvec3 w;
  for (int i = 0; i < 16; ++i) {
    w = inwards(any_vector(random, shape), one);
    if (inwards(w, other) == w) break;
  }
  return w;
}

/// The ways in which two shapes have points in common.
enum class Tie : std::uint8_t {
  twins,         ///< the same surface twice, one of them longer where it is a cylinder
  cone_on_base,  ///< a cone on the base of a cylinder
  crossing_sphere,
};
constexpr std::array ties{Tie::twins, Tie::cone_on_base, Tie::crossing_sphere,
                          Tie::crossing_sphere};  // half are spheres

/// A sphere through a point of the first shape, from any side; or one that fits in a cylinder and touches it around.
void add_crossing_sphere(Draws& random, FramedShapes& shapes) {
  const FramedShape first = shapes[0];
  FramedShape sphere = lattice_shape(random, Tipo::soy_esfera);
  const bool fits = first.tipo == Tipo::soy_cilindro && random.chance(1, 2);
  const FramedPoint shared = surface_point(random, first);
  if (fits) {
    sphere.radio = first.radio;
    sphere.centro = first.centro + std::floor(first.altura / 2) * first.d;
    for (int i = 0; i < 8; ++i) {
      const FramedPoint at = surface_point_at(random, first, std::floor(first.altura / 2) / first.altura);
      shapes[0].shared.push_back(at);
      sphere.shared.push_back(at);
    }
  } else {
    sphere.centro = glm::dvec3(0);
    FramedPoint at = surface_point(random, sphere);
    sphere.centro = shared.position - at.radial;
    at.position = shared.position;
    shapes[0].shared.push_back(shared);
    sphere.shared.push_back(at);
  }
  shapes.push_back(sphere);
}

/// A cone on the base of the first cylinder.
void add_cone_on_base(Draws& random, FramedShapes& shapes) {
  FramedShape cone = shapes[0];
  cone.tipo = Tipo::soy_cono;
  cone.proporcion = std::ldexp(1, random.integer(-2, 2));
  cone.altura = shapes[0].radio / cone.proporcion;
  for (int i = 0; i < 8; ++i) {
    const FramedPoint of_cone = surface_point_at(random, cone, 0);
    FramedPoint of_cylinder = of_cone;
    of_cylinder.along = cone.d;
    shapes[0].shared.push_back(of_cylinder);
    cone.shared.push_back(of_cone);
  }
  shapes.push_back(cone);
}

}  // namespace

DrawnRay apex(Draws& random, int log2_distance, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes);
  const glm::dvec3 w = any_vector(random, shape);
  return one_in_three_nudged(random, arriving(random, shape.apex(), w, steps(w, shape.radius(), log2_distance)));
}

FramedShapes rim(Draws& random, int) {
  FramedShapes shapes = some_axial(random, 0);
  if (random.chance(1, 3)) shapes = {tilted_with_exact_rims(random)};
  return shapes;
}

DrawnRay rim(Draws& random, int log2_distance, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes);
  if (!shape.lattice && shape.centro == glm::dvec3(0))
    return one_in_three_nudged(random, in_plane_of_rim(random, shape));
  const FramedPoint at = rim_point(random, shape);
  glm::dvec3 w = any_vector(random, shape);
  if (random.chance(3, 4)) w = inwards(w, at);
  return one_in_three_nudged(random, arriving(random, at.position, w, steps(w, shape.radius(), log2_distance)));
}

DrawnRay inside(Draws& random, int quarters, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes);
  const FramedPoint side = surface_point(random, shape);
  const glm::dvec3 p = side.position - (quarters / 4.0) * side.radial;
  const FramedPoint exit = random.chance(1, 3) ? rim_point(random, shape) : surface_point(random, shape);
  return {p, std::ldexp(1, random.integer(-3, 3)) * (exit.position - p)};
}

FramedShapes with_twin(Draws& random, int) {
  FramedShapes shapes = some(random, 0);
  if (random.chance(1, 3)) shapes.push_back(shapes[0]);
  return shapes;
}

DrawnRay on_surface(Draws& random, int percent_named, ShapeSpan shapes) {
  const std::size_t place = random.below(shapes.size());
  const FramedShape& shape = shapes[place];
  const FramedPoint at = random.chance(1, 4) ? rim_point(random, shape) : surface_point(random, shape);
  const glm::dvec3 w = random.chance(1, 4) ? tangent_vector(random, at) : any_vector(random, shape);
  DrawnRay ray{at.position, random.signed_power(-3, 3) * w};
  if (!shape.lattice && random.chance(1, 2)) ray = nudged(random, ray);
  if (random.integer(0, 99) >= percent_named) return ray;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const bool twin =
        shapes[i].centro == shape.centro && shapes[i].tipo == shape.tipo && shapes[i].vertices == shape.vertices;
    if (i == place || twin) ray.on.push_back(i);
  }
  return ray;
}

FramedShapes tangent(Draws& random, int) {
  FramedShapes shapes = some_round(random, 0);
  if (!random.chance(1, 4)) return shapes;
  FramedShape shape;
  do shape = tilted_shape(random, any_axial_type(random));
  while (shape.d.x != 0 && shape.d.y != 0 && shape.d.z != 0);
  shape.centro = glm::dvec3(0);
  shapes[0] = shape;
  return shapes;
}

DrawnRay tangent(Draws& random, int log2_distance, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes);
  if (const auto ray = tangent_to_tilted(random, shape)) return one_in_three_nudged(random, *ray);
  const FramedPoint at = surface_point(random, shape);
  const glm::dvec3 u = tangent_vector(random, at);
  return one_in_three_nudged(random, arriving(random, at.position, u, steps(u, shape.radius(), log2_distance)));
}

DrawnRay zero_b(Draws& random, int percent_from_centre, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes);
  // A ray from the centre of a sphere or of a cylinder's base has B = 0 whatever the axis.
  if (has_constant_radius(shape.tipo) && random.integer(0, 99) < percent_from_centre) {
    glm::dvec3 w = any_vector(random, shape);
    if (glm::dot(w, shape.d) < 0) w = -w;
    return {shape.centro, w};
  }
  // A ray from the middle of a chord has opposite roots.
  const FramedPoint one = surface_point(random, shape), other = surface_point(random, shape);
  const DrawnRay ray{0.5 * (one.position + other.position),
                     std::ldexp(1, random.integer(-3, 3)) * (other.position - one.position)};
  return random.chance(1, 4) ? nudged(random, ray) : ray;
}

FramedShapes tie(Draws& random, int) {
  switch (random.any_of(ties)) {
    case Tie::twins: {
      FramedShapes shapes{any_shape(random, any_type(random))};
      shapes.push_back(shapes[0]);
      if (shapes[0].tipo == Tipo::soy_cilindro) shapes[1].altura *= random.integer(1, 3);
      return shapes;
    }
    case Tie::cone_on_base: {
      FramedShapes shapes{lattice_shape(random, Tipo::soy_cilindro)};
      add_cone_on_base(random, shapes);
      return shapes;
    }
    case Tie::crossing_sphere: {
      FramedShapes shapes{lattice_shape(random, any_type(random))};
      add_crossing_sphere(random, shapes);
      return shapes;
    }
  }
  contract::unreachable();
}

DrawnRay tie(Draws& random, int log2_distance, ShapeSpan shapes) {
  const FramedShape& shape = shapes[0];
  if (shape.shared.empty()) return ordinary(random, shape, log2_distance);
  const std::size_t i = random.below(shape.shared.size());
  const glm::dvec3 w = entering_both(random, shape, shape.shared[i], shapes[1].shared[i]);
  const DrawnRay ray = arriving(random, shape.shared[i].position, w, steps(w, shape.radius(), log2_distance));
  return random.chance(1, 4) ? nudged(random, ray) : ray;
}

}  // namespace durero::conform::recipes
