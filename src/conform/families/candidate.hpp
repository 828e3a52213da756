#pragma once
/// A candidate is an element that a query may hit, as exact arithmetic sees it; the questions of members.hpp are asked
/// about candidates.

#include <algorithm>

#include "conform/families/framed_shape.hpp"
#include "conform/families/members.hpp"
#include "durero/surface/exact.hpp"

namespace durero::conform {

using number::Dyadic;
using surface::exact::Parameter;

struct DyadicVector {
  Dyadic x, y, z;
};
DyadicVector exact(const glm::dvec3& v);
/// The exact difference a − b.
DyadicVector difference(const glm::dvec3& a, const glm::dvec3& b);
Dyadic dot(const DyadicVector& a, const DyadicVector& b);
DyadicVector cross(const DyadicVector& a, const DyadicVector& b);
Dyadic squared_length(const glm::dvec3& v);
Dyadic magnitude(const Dyadic& x);

/// Whether |part| is at most 2⁻²⁰ of |whole|.
bool negligible(const Dyadic& part, const Dyadic& whole);

/// An element of a scene, and the query's quadratic on it.
struct ElementQuadratic {
  scene::ElementRef e;
  surface::exact::Coefficients f;
  glm::dvec3 centro;
  Dyadic size;          ///< the radius, of a narrowing shape at the base; of a triangle the radius of its ball
  glm::dvec3 vector{};  ///< the axis, where the shape has one
  double altura = 0;    ///< the height, where the shape has an axis
  Dyadic normal = 1;    ///< the square of potencia / distance from the plane, of a flat shape

  bool is_axial() const { return f.altura.has_value(); }
  bool is_flat() const { return conform::is_flat(e.tipo); }
  Dyadic discriminant() const { return square(f.B) - f.A * f.C; }
  /// The parameter of the nearest point. Precondition: the query hits this element first.
  Parameter first() const { return reach(f).first(); }
  /// The sign of avance at t less altura. Precondition: the shape has an axis.
  int sign_beyond(const Parameter& t) const;
  /// Whether the shape has an axis and avance at t is exactly 0 or altura.
  bool is_at_end(const Parameter& t) const;
  /// Whether the origin of the ray lies between the ends of the shape; true of a shape without ends.
  bool starts_between_ends() const;
};

/// The element and its coefficients alone; C = 0 where the query's origin is named to lie on it.
ElementQuadratic quadratic(const AnsweredQuery& q, scene::ElementRef e);
/// The candidate of an element; C = 0 where the ray starts `on` it.
ElementQuadratic candidate(const AnsweredQuery& q, scene::ElementRef e, bool on);
/// The candidate of an element; C = 0 where the query's origin is named to lie on it.
ElementQuadratic candidate(const AnsweredQuery& q, scene::ElementRef e);

/// Whether the condition holds for some element of the scene.
template <class Holds>
bool any_element(const AnsweredQuery& q, Holds holds) {
  return q.scene.any_of([&](scene::ElementRef e, const auto&) { return holds(candidate(q, e)); });
}

/// Whether the condition holds for some element that the query hits.
template <class Holds>
bool any_hit_element(const AnsweredQuery& q, Holds holds) {
  const scene::ElementSet& all = q.hit.elementos;
  return hits(q) && std::any_of(all.begin(), all.end(), [&](scene::ElementRef e) { return holds(candidate(q, e)); });
}

/// Whether the condition holds for some element of the answer: a hit, or no minimum.
template <class Holds>
bool any_met_element(const AnsweredQuery& q, Holds holds) {
  const scene::ElementSet& all = q.hit.elementos;
  return std::any_of(all.begin(), all.end(), [&](scene::ElementRef e) { return holds(candidate(q, e)); });
}

/// Whether the condition holds for some root t > 0, within the ends of the element or beyond them.
template <class Holds>
bool any_root_ahead(const ElementQuadratic& c, Holds holds) {
  const surface::exact::Roots all = roots(c.f);
  const auto values = all.values();
  return std::any_of(values.begin(), values.end(), [&](const Parameter& t) { return number::sign(t) > 0 && holds(t); });
}

/// Whether the origin of the ray lies within the element; false of a flat shape.
bool is_inside(const ElementQuadratic& c);

/// Whether t·|v| ≥ distance, for t as it is rounded; an infinite t is far enough. Precondition: the query hits.
bool travels_at_least(const AnsweredQuery& q, const Dyadic& distance);

}  // namespace durero::conform
