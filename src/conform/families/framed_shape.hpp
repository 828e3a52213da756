#pragma once
/// A framed shape is a shape under construction. It is built with points of its surface and the tangent plane there, so
/// that a ray of any kind can be laid through such a point (drawn_ray.hpp).
///
/// Lattice shapes have a unit axis ±x, ±y or ±z and integer coordinates: their surface points come from Pythagorean
/// triples and quadruples (lattice.hpp) and their rays are integer combinations, so every coincidence is exact; a
/// lattice triangle has any integer vertices. Tilted shapes have any axis, and their coincidences are off by roundings.
/// All numbers are of the format that is drawn.

#include <optional>
#include <vector>

#include "conform/families/draws.hpp"
#include "durero/scene/shapes.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::conform {

/// A point of a surface, with directions. `radial` goes from the axis (or the centre of a sphere) to the point; on a
/// flat shape it is the normal. `around` and `along` lie in the tangent plane, and span it unless a sphere drew them
/// parallel; `along` is the direction of the generator.
struct FramedPoint {
  glm::dvec3 position, radial, around, along;
};

/// A shape of any type with an orthonormal frame e1, e2, d, which is exact for lattice shapes; d is vector. An
/// attribute that the type does not have has no meaning. A shape with a proportion has the radius
/// radio + proporcion·(altura − s) at the advance s, where a cone's radio counts as 0. The frame of a triangle is its
/// edges from the first vertex, and their product.
struct FramedShape {
  model::Tipo tipo{};
  bool lattice = true;
  glm::dvec3 centro{};
  double radio = 0;  ///< of a plane: the reach of drawn points around centro; of a triangle: the longer of e1 and e2
  double proporcion = 0;
  double altura = 0;
  scene::Corners vertices{};
  glm::dvec3 e1{}, e2{}, d{};
  std::vector<FramedPoint> shared{};  ///< points of the surface that lie on another shape too

  /// The radius, of a narrowing shape at its base.
  double radius() const;
  /// Whether radius() was not rounded.
  bool has_exact_radius() const;
  /// The far end of the axis, which is the apex of a cone.
  glm::dvec3 apex() const { return centro + altura * d; }
  /// The operation that adds the shape to a scene.
  model::Operation addition(const model::Elemento& e) const;
};

/// Whether shapes of the type have an axis that they lie around.
bool is_axial(model::Tipo tipo);
/// Whether shapes of the type have the same radius everywhere.
bool has_constant_radius(model::Tipo tipo);
/// Whether shapes of the type narrow to a point.
bool has_apex(model::Tipo tipo);

/// Whether shapes of the type are a plane across d, or part of it.
using surface::is_flat;

/// @{ A random type that is not flat. Where only flat ones are asked for, any_type draws a disc or a triangle instead.
model::Tipo any_type(Draws& random);
model::Tipo any_round_type(Draws& random);
/// @}
/// A random type without a bound: the plane.
model::Tipo any_unbounded_type(Draws& random);
/// A random type with an axis.
model::Tipo any_axial_type(Draws& random);

/// Whether the vertices make a triangle: they lie on no line, exactly.
bool are_corners(const scene::Corners& vertices);
/// The triangle with these vertices. Precondition: are_corners(vertices).
FramedShape triangle(const scene::Corners& vertices, bool lattice);

/// A random lattice shape. The edges of a triangle are multiples of 8, so that eighths of them are of the lattice too.
FramedShape lattice_shape(Random& random, model::Tipo tipo);
FramedShape tilted_shape(Draws& random, model::Tipo tipo);
/// A random lattice or tilted shape, two to one.
FramedShape any_shape(Draws& random, model::Tipo tipo);

/// The disc across the base or across the other end; its radio and centro may be rounded. Precondition: the shape has
/// an axis.
FramedShape closing_disc(const FramedShape& shape, bool at_base);

/// Gives the shape another axis, and a frame around that. Precondition: e1 is not along d.
void turn_to(FramedShape& shape, const glm::dvec3& d);

/// The vector times 2^k.
glm::dvec3 times_power(const glm::dvec3& v, int k);

/// The shape moved; a triangle whose vertices would then lie on one line stays where it is.
FramedShape moved(FramedShape shape, const glm::dvec3& by);

/// The shape with all lengths times 2^k, and without its shared points.
FramedShape scaled(FramedShape shape, int k);

/// The shape with every number rounded to the format, and a unit vector near d in it; nothing where the result is no
/// valid shape.
std::optional<FramedShape> in_format(const Draws& random, FramedShape shape);

}  // namespace durero::conform
