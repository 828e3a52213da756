#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "conform/families/recipes.hpp"

namespace durero::conform::recipes {
namespace {

using model::Tipo;

/// A turn around a unit vector by the angle whose half has this tangent. Its sine and cosine need no such functions,
/// which differ from one platform to another.
struct Turn {
  glm::dvec3 around;
  double tangent;

  glm::dvec3 operator()(const glm::dvec3& v) const {
    const double square = tangent * tangent, sine = 2 * tangent / (1 + square), cosine = (1 - square) / (1 + square);
    return cosine * v + sine * glm::cross(around, v) + (1 - cosine) * glm::dot(around, v) * around;
  }
};

/// The vector of length 1: it is rounded seven times at most, and its square is off by 7·2⁻⁵³ < 2⁻⁵⁰.
glm::dvec3 unit(const glm::dvec3& v) { return v / std::sqrt(glm::dot(v, v)); }

/// The shape turned about 0.
FramedShape turned(FramedShape shape, const Turn& turn) {
  if (shape.tipo == Tipo::soy_triangulo) {
    scene::Corners vertices = shape.vertices;
    for (glm::dvec3& vertex : vertices) vertex = turn(vertex);
    return are_corners(vertices) ? triangle(vertices, false) : shape;
  }
  shape.lattice = false;
  shape.centro = turn(shape.centro);
  if (!is_axial(shape.tipo) && !is_flat(shape.tipo)) return shape;
  shape.e1 = turn(shape.e1);
  turn_to(shape, unit(turn(shape.d)));
  return shape;
}

/// A length or a coordinate of the shape.
double& any_number(Draws& random, FramedShape& shape) {
  double& length = has_apex(shape.tipo) ? shape.proporcion : shape.radio;
  return random.chance(1, 2) ? length : shape.centro[random.integer(0, 2)];
}

/// The shape with one number moved by so many units in its last place; for a triangle one coordinate of every vertex.
FramedShape moved(Draws& random, FramedShape shape, int units) {
  const double way = random.sign();
  const auto move = [&](double& x) {
    for (int i = 0; i < units; ++i) x = random.next(x, way);
  };
  if (shape.tipo != Tipo::soy_triangulo) {
    move(any_number(random, shape));
    return shape;
  }
  const int coordinate = random.integer(0, 2);
  scene::Corners vertices = shape.vertices;
  for (glm::dvec3& vertex : vertices) move(vertex[coordinate]);
  return are_corners(vertices) ? triangle(vertices, false) : shape;
}

}  // namespace

/// The same elements at every scale.
FramedShapes scale(Draws& random, int log2_scale) {
  Draws always_the_same(0, random.options());
  FramedShapes shapes = as_many(always_the_same, 5);
  for (FramedShape& shape : shapes) shape = scaled(shape, log2_scale);
  return shapes;
}

DrawnRay scale(Draws& random, int log2_scale, ShapeSpan shapes) {
  const FramedShape shape = scaled(random.any_of(shapes), -log2_scale);
  return scaled(ordinary(random, shape, random.integer(0, 4)), log2_scale);
}

FramedShapes rotation(Draws& random, int tangent_in_64ths) {
  const Turn turn{random.direction(), tangent_in_64ths / 64.0};
  FramedShapes shapes = as_many(random, random.integer(1, 6));
  for (FramedShape& shape : shapes) shape = turned(shape, turn);
  return shapes;
}

FramedShapes parked(Draws& random, int units) {
  static const std::vector<Tipo> types{Tipo::soy_esfera, Tipo::soy_cilindro, Tipo::soy_cono,
                                       Tipo::soy_tronco, Tipo::soy_disco,    Tipo::soy_triangulo};
  FramedShapes shapes{any_shape(random, random.any_type_of(types))};
  shapes.push_back(moved(random, shapes[0], units));
  return shapes;
}

}  // namespace durero::conform::recipes
