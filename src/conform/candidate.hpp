#pragma once
/// The elements that a query may hit, as exact arithmetic sees them: what the questions of members.hpp are asked of.

#include <algorithm>

#include "conform/framed_shape.hpp"
#include "conform/members.hpp"
#include "durero/surface/exact.hpp"

namespace durero::conform {

using number::Dyadic;
using surface::exact::Parameter;

struct ExactVector {
  Dyadic x, y, z;
};
ExactVector exact(const glm::dvec3& v);
/// a − b
ExactVector difference(const glm::dvec3& a, const glm::dvec3& b);
Dyadic dot(const ExactVector& a, const ExactVector& b);
ExactVector cross(const ExactVector& a, const ExactVector& b);
Dyadic squared_length(const glm::dvec3& v);
Dyadic magnitude(const Dyadic& x);

/// |part| is at most 2⁻²⁰ of |whole|.
bool negligible(const Dyadic& part, const Dyadic& whole);

/// An element of a scene, and the query's quadratic on it.
struct Candidate {
  scene::ElementRef e;
  surface::exact::Coefficients f;
  glm::dvec3 centro;
  Dyadic size;          ///< the radius, at the base where it is not the same everywhere; of a triangle that of its ball
  glm::dvec3 vector{};  ///< of a shape with an axis
  double altura = 0;    ///< the same
  Dyadic normal = 1;    ///< of a flat shape: the square of what its potencia is times the distance from its plane

  bool is_axial() const { return f.altura.has_value(); }
  bool is_flat() const { return conform::is_flat(e.tipo); }
  Dyadic discriminant() const { return square(f.B) - f.A * f.C; }
  /// The nearest point. Precondition: the query hits this element first.
  Parameter first() const { return reach(f).first(); }
  /// The avance at t less altura, and its sign. Precondition: the shape has an axis.
  int sign_beyond(const Parameter& t) const;
  /// Whether avance at t is exactly 0 or altura.
  bool is_at_end(const Parameter& t) const;
  /// Whether the origin of the ray lies between the ends, where the shape has such.
  bool starts_between_ends() const;
};

/// With C = 0 where the ray starts on the element, or not.
Candidate candidate(const AnsweredQuery& q, scene::ElementRef e, bool on);
/// With C = 0 where the query names the element.
Candidate candidate(const AnsweredQuery& q, scene::ElementRef e);

/// Whether it holds of some element of the scene.
template <class Holds>
bool any_element(const AnsweredQuery& q, Holds holds) {
  return q.scene.any_of([&](scene::ElementRef e, const auto&) { return holds(candidate(q, e)); });
}

/// Whether it holds of some element that the query hits.
template <class Holds>
bool any_hit_element(const AnsweredQuery& q, Holds holds) {
  const scene::ElementSet& all = q.hit.elementos;
  return hits(q) && std::any_of(all.begin(), all.end(), [&](scene::ElementRef e) { return holds(candidate(q, e)); });
}

/// Whether it holds of some element that the query meets: hits, or has no minimum on.
template <class Holds>
bool any_met_element(const AnsweredQuery& q, Holds holds) {
  const scene::ElementSet& all = q.hit.elementos;
  return std::any_of(all.begin(), all.end(), [&](scene::ElementRef e) { return holds(candidate(q, e)); });
}

/// Whether it holds of some root t > 0, within the ends or beyond.
template <class Holds>
bool any_root_ahead(const Candidate& c, Holds holds) {
  const surface::exact::Roots all = roots(c.f);
  const auto values = all.values();
  return std::any_of(values.begin(), values.end(), [&](const Parameter& t) { return number::sign(t) > 0 && holds(t); });
}

/// The origin of the ray lies within the element, which is not flat.
bool is_inside(const Candidate& c);

/// t·|v| ≥ distance, for t as it is rounded. Precondition: the query hits.
bool travels_at_least(const AnsweredQuery& q, const Dyadic& distance);

}  // namespace durero::conform
