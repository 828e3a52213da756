#include <cmath>

#include "conform/families/recipes.hpp"

namespace durero::conform::recipes {
namespace {

using model::Tipo;

/// The shape moved so near to 0, by its centre or its first vertex, that a rounding of its place is no more than one of
/// its size.
FramedShape near_zero(Draws& random, FramedShape shape) {
  if (shape.tipo == Tipo::soy_triangulo) return triangle({glm::dvec3(0), shape.e1, shape.e2}, shape.lattice);
  shape.centro = random.lattice_vector(8);
  return shape;
}

/// A point of a triangle at an edge or a vertex, moved inwards by the share `inwards`, which becomes the least of its
/// barycentric coordinates.
FramedPoint beside_edge(Draws& random, const FramedShape& shape, double inwards) {
  const std::size_t i = random.below(3);
  const glm::dvec3 &from = shape.vertices[i], &to = shape.vertices[(i + 1) % 3], &other = shape.vertices[(i + 2) % 3];
  const double part = random.chance(1, 2) ? 0 : random.integer(1, 7) / 8.0;
  const glm::dvec3 edge = from + part * (to - from);
  const glm::dvec3 way = part == 0 ? (to - from) + (other - from) : other - edge;
  return {edge + inwards * way, shape.d, shape.e1, shape.e2};
}

/// A point within the bound of the shape by the share `inwards` of its size, beyond it where that is negative: of
/// altura within an end, of the radius within the rim of a disc or the limb of a sphere.
FramedPoint beside_bound(Draws& random, const FramedShape& shape, double inwards) {
  if (shape.tipo == Tipo::soy_triangulo) return beside_edge(random, shape, inwards);
  if (is_axial(shape.tipo)) return surface_point_at(random, shape, random.chance(1, 2) ? inwards : 1 - inwards);
  FramedPoint at = rim_point(random, shape);
  at.position -= inwards * (is_flat(shape.tipo) ? at.along : at.radial);
  return at;
}

/// The direction of a ray through such a point: for a sphere in its limb's plane, so that the ray comes no nearer; for
/// a shape with an axis mostly inwards, so that the ray meets it there first.
glm::dvec3 direction(Draws& random, const FramedShape& shape, const FramedPoint& at) {
  if (shape.tipo == Tipo::soy_esfera) return tangent_vector(random, at);
  if (!is_axial(shape.tipo)) return any_vector(random, shape);
  const glm::dvec3 w = random.chance(1, 4) ? perpendicular_vector(random, shape) : any_vector(random, shape);
  return random.chance(7, 8) ? inwards(w, at) : w;
}

}  // namespace

FramedShapes bounded(Draws& random, int) {
  static const std::vector<Tipo> types{Tipo::soy_esfera, Tipo::soy_cilindro, Tipo::soy_cono,
                                       Tipo::soy_tronco, Tipo::soy_disco,    Tipo::soy_triangulo};
  return {near_zero(random, any_shape(random, random.any_type_of(types)))};
}

/// The origin is rounded first, so that only v is off by a rounding.
DrawnRay margin(Draws& random, int minus_log2_margin, ShapeSpan shapes) {
  const FramedShape& shape = random.any_of(shapes);
  const double inwards = random.sign() * std::ldexp(1, -minus_log2_margin);
  const FramedPoint at = beside_bound(random, shape, inwards);
  const glm::dvec3 w = direction(random, shape, at), to = random.rounded(at.position);
  const glm::dvec3 p = random.rounded(to - steps(w, shape.radius(), random.integer(0, 2)) * w);
  return {p, std::ldexp(1, random.integer(-3, 3)) * (to - p)};
}

}  // namespace durero::conform::recipes
