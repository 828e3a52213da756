#pragma once
/// A ray and an element by exact arithmetic: every quantity for which a step states a bound (trace/quadratic-inl.hpp
/// has their letters), and how far a computed number is from it. A root is taken to 600 bits, which is exact for any
/// bound.

#include <algorithm>

#include "durero/scene/any_shape.hpp"
#include "durero/surface/exact_element.hpp"
#include "support/exact_vector.hpp"
#include "trace/steps.hpp"

namespace durero::test {

using Element = scene::AnyShape;

/// on: the ray starts on the element.
struct Specimen {
  Element element;
  glm::dvec3 p, v;
  bool on = false;

  model::Rayo rayo() const { return {model::Punto(p), model::Vector(v)}; }
};

/// of_surface ∓ of_line: F and H.
struct Distances {
  Dyadic of_surface, of_line;
};

inline Distances distances(const scene::Sphere& e, const Exact_Vector& p, const Exact_Vector& v) {
  return {Dyadic(e.radio) * length(v), length(cross(p - Exact_Vector(e.centro), v))};
}
inline Distances distances(const scene::Cylinder& e, const Exact_Vector& p, const Exact_Vector& v) {
  const Exact_Vector q = p - Exact_Vector(e.centro), d(e.vector);
  const Exact_Vector a = v - dot(v, d) * d, b = q - dot(q, d) * d;
  return {Dyadic(e.radio) * length(a), length(cross(b, a))};
}
inline Distances distances(const scene::Cone& e, const Exact_Vector& p, const Exact_Vector& v) {
  const Exact_Vector q = p - Exact_Vector(e.centro), d(e.vector);
  const Dyadic s0 = dot(q, d), s1 = dot(v, d);
  const Exact_Vector a = v - s1 * d, b = q - s0 * d;
  return {Dyadic(e.proporcion) * length((Dyadic(e.altura) - s0) * a + s1 * b), length(cross(b, a))};
}

inline Distances distances(const scene::TruncatedCone& e, const Exact_Vector& p, const Exact_Vector& v) {
  const Exact_Vector q = p - Exact_Vector(e.centro), d(e.vector);
  const Dyadic s0 = dot(q, d), s1 = dot(v, d), k(e.proporcion);
  const Exact_Vector a = v - s1 * d, b = q - s0 * d;
  return {length((Dyadic(e.radio) + k * (Dyadic(e.altura) - s0)) * a + (k * s1) * b), length(cross(b, a))};
}

// The line of a flat shape's quadratic has none.
inline Distances distances(const scene::Plane&, const Exact_Vector&, const Exact_Vector&) { return {}; }
inline Distances distances(const scene::Disc&, const Exact_Vector&, const Exact_Vector&) { return {}; }
inline Distances distances(const scene::Triangle&, const Exact_Vector&, const Exact_Vector&) { return {}; }

/// How far within its edge the line crosses a bounded flat shape, as the headers of trace/shape have it.
inline Dyadic margin(const scene::Disc& e, const Exact_Vector& p, const Exact_Vector& v) {
  const Exact_Vector q = p - Exact_Vector(e.centro), d(e.vector);
  const Dyadic s0 = dot(q, d), s1 = dot(v, d);
  return Dyadic(e.radio) * magnitude(s1) - length(s1 * q - s0 * v);
}
inline Dyadic margin(const scene::Triangle& e, const Exact_Vector& p, const Exact_Vector& v) {
  const Exact_Vector a(e.vertices[0]), e1 = Exact_Vector(e.vertices[1]) - a, e2 = Exact_Vector(e.vertices[2]) - a;
  const Exact_Vector q = p - a, v_e2 = cross(v, e2), q_e1 = cross(q, e1);
  const Dyadic det = dot(e1, v_e2), ca = dot(q, v_e2), ab = dot(v, q_e1);
  const Dyadic side = number::sign(det) < 0 ? -1 : 1;
  return std::min({side * ab, side * (det - ca - ab), side * ca});
}

/// The coefficients are those of the exact step; S = √D, or 0 where D is negative.
struct Exact : surface::exact::Coefficients {
  Dyadic F, H, D, S;

  template <class Shape>
  Exact(const Shape& shape, const model::Rayo& rayo, bool on)
      : surface::exact::Coefficients(surface::exact::coefficients(shape, rayo, on)) {
    const auto [of_surface, of_line] = distances(shape, Exact_Vector(rayo.p().xyz()), Exact_Vector(rayo.v().xyz()));
    F = of_surface - of_line;
    H = of_surface + of_line;
    D = B * B - A * C;
    S = number::sign(D) > 0 ? root(D) : Dyadic();
  }

  Dyadic quadratic(const Dyadic& t) const { return (A * t + B + B) * t + C; }
};

/// The parameter, its root taken to 600 bits.
inline Fraction fraction(const surface::exact::Parameter& t) { return {t.x + t.y * root(t.delta), t.w}; }

}  // namespace durero::test
