#pragma once
/// Elements and rays under construction. An element is built with a point of its surface, and the plane that touches
/// it there, so that a ray of any kind can be laid through that point.
///
/// Lattice elements have a unit axis ±x, ±y or ±z and integer coordinates: their touching points come from Pythagorean
/// triples and quadruples and their rays are integer combinations, so every coincidence is exact. Tilted elements have
/// any axis, and their coincidences are off by roundings.

#include <span>
#include <vector>

#include "durero/conform/families.hpp"

namespace durero::conform {

/// A point of a surface. radial: from the axis (or the centre of a sphere) to it; around and along span the plane that
/// touches there, along is the direction of the generator.
struct Touch {
  glm::dvec3 point, radial, around, along;
};

/// e1, e2, d: an orthonormal base, exactly for lattice elements. `size` is radio, or proporcion for a cone.
struct Body {
  model::Tipo tipo{};
  bool lattice = true;
  glm::dvec3 centro{};
  double size = 0;
  double altura = 0;  ///< of no meaning for a sphere
  glm::dvec3 e1{}, e2{}, d{};
  std::vector<Touch> marks{};  ///< points of the surface that it shares with another element

  /// The radius at the base.
  double radius() const { return tipo == model::Tipo::soy_cono ? size * altura : size; }
  glm::dvec3 apex() const { return centro + altura * d; }
  model::Operation operation(const model::Elemento& e) const;
};

/// A ray p + t·v; `on` are the places of the elements that p lies on.
struct Shot {
  glm::dvec3 p, v;
  std::vector<std::size_t> on{};
};

Body lattice_body(Random& random, model::Tipo tipo);
Body tilted_body(Random& random, model::Tipo tipo);
/// Of either sort.
Body any_body(Random& random, model::Tipo tipo);
model::Tipo any_type(Random& random);
/// Cylinder or cone.
model::Tipo any_axial_type(Random& random);

/// All lengths times 2^k; the marks go.
Body scaled(Body body, int k);
Shot scaled(Shot shot, int k);

/// A point at the given height of an axial element: part of altura, a multiple of 1/8 (0 the base, 1 the other end).
Touch touch_at(Random& random, const Body& body, double part);
/// Anywhere on it; at a rim where it has one; not at an apex.
Touch touch(Random& random, const Body& body);
Touch rim_touch(Random& random, const Body& body);

/// A vector with small integer coordinates for a lattice element, any direction of that length for a tilted one.
glm::dvec3 any_vector(Random& random, const Body& body);
/// In the plane that touches, and not along the generator.
glm::dvec3 tangent_vector(Random& random, const Body& body, const Touch& touch);
/// Across the axis.
glm::dvec3 perpendicular_vector(Random& random, const Body& body);
/// The vector or its opposite: into the element at that point.
glm::dvec3 inwards(const glm::dvec3& v, const Touch& touch);

/// The ray that reaches the point along w from m·w before it; its v is w times a small power of two.
Shot arriving(Random& random, const glm::dvec3& point, const glm::dvec3& w, double m);
/// The power of two that makes m·|w| about 2^e times the size. Precondition: w ≠ 0.
double steps(const glm::dvec3& w, double size, int e);

/// The next number after, or before, one of the coordinates of p or of v.
Shot nudged(Random& random, Shot shot);

/// A ray on which some coincidence holds, exactly where the element is a lattice one: tangent, through a rim or the
/// apex, across the axis, or along a generator's direction. It starts about 2^e sizes before the point.
Shot coincident(Random& random, const Body& body, int e);
/// One in three coincident, the rest through a point of the surface in any direction, mostly into the element.
Shot ordinary(Random& random, const Body& body, int e);

}  // namespace durero::conform
