#include "conform/families/candidate.hpp"

#include <cmath>

#include "durero/surface/surfaces.hpp"

namespace durero::conform {
namespace {

/// The radius of the ball of a triangle, which is made at a moderate scale, where no square overflows or vanishes.
Dyadic radius_of_ball(scene::Triangle triangle) {
  double greatest = 0;
  for (const glm::dvec3& v : triangle.vertices)
    greatest = std::max({greatest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const int k = std::ilogb(greatest);  // the vertices are not all 0
  for (glm::dvec3& vertex : triangle.vertices) vertex = times_power(vertex, -k);
  return number::shifted(Dyadic(surface::ball(triangle).radius), k);
}

template <class Shape>
Dyadic size(const Shape& shape) {
  Dyadic radius;
  if constexpr (requires { shape.radio; }) radius = shape.radio;
  if constexpr (requires { shape.proporcion; }) radius = radius + Dyadic(shape.proporcion) * Dyadic(shape.altura);
  if constexpr (requires { shape.vertices; }) radius = radius_of_ball(shape);
  return radius;
}

Dyadic squared_normal(const scene::Corners& vertices) {
  const DyadicVector n = cross(difference(vertices[1], vertices[0]), difference(vertices[2], vertices[0]));
  return dot(n, n);
}

/// The centre of a shape, or the first vertex of a triangle.
template <class Shape>
const glm::dvec3& centre(const Shape& shape) {
  if constexpr (requires { shape.centro; })
    return shape.centro;
  else
    return shape.vertices[0];
}

/// Whether the query's origin is named to lie on the element.
bool is_on(const AnsweredQuery& q, scene::ElementRef e) { return scene::Origin(q.query.en).contains(e); }

}  // namespace

DyadicVector exact(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
DyadicVector difference(const glm::dvec3& a, const glm::dvec3& b) {
  return {Dyadic(a.x) - Dyadic(b.x), Dyadic(a.y) - Dyadic(b.y), Dyadic(a.z) - Dyadic(b.z)};
}
Dyadic dot(const DyadicVector& a, const DyadicVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
DyadicVector cross(const DyadicVector& a, const DyadicVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Dyadic squared_length(const glm::dvec3& v) { return dot(exact(v), exact(v)); }
Dyadic magnitude(const Dyadic& x) { return number::sign(x) < 0 ? -x : x; }

bool negligible(const Dyadic& part, const Dyadic& whole) {
  return number::shifted(magnitude(part), 20) <= magnitude(whole);
}

int ElementQuadratic::sign_beyond(const Parameter& t) const {
  return number::sign(number::linear(f.s0 - *f.altura, f.s1, t));
}

bool ElementQuadratic::is_at_end(const Parameter& t) const {
  return is_axial() && (number::sign(number::linear(f.s0, f.s1, t)) == 0 || sign_beyond(t) == 0);
}

bool ElementQuadratic::starts_between_ends() const {
  return !is_axial() || (number::sign(f.s0) >= 0 && f.s0 <= *f.altura);
}

ElementQuadratic quadratic(const AnsweredQuery& q, scene::ElementRef e) {
  const auto of = [&](const auto& shape) { return surface::exact::coefficients(shape, q.query.rayo, is_on(q, e)); };
  return {e, q.scene.visit(e, of), {}, {}};
}

ElementQuadratic candidate(const AnsweredQuery& q, scene::ElementRef e, bool on) {
  return q.scene.visit(e, [&]<class Shape>(const Shape& shape) {
    ElementQuadratic c{e, surface::exact::coefficients(shape, q.query.rayo, on), centre(shape), size(shape)};
    if constexpr (requires { shape.vector; }) c.vector = shape.vector;
    if constexpr (requires { shape.altura; }) c.altura = shape.altura;
    if constexpr (requires { shape.vertices; }) c.normal = squared_normal(shape.vertices);
    return c;
  });
}

ElementQuadratic candidate(const AnsweredQuery& q, scene::ElementRef e) { return candidate(q, e, is_on(q, e)); }

bool is_inside(const ElementQuadratic& c) { return !c.is_flat() && number::sign(c.f.C) < 0 && c.starts_between_ends(); }

bool travels_at_least(const AnsweredQuery& q, const Dyadic& distance) {
  if (!std::isfinite(q.hit.t)) return true;
  return square(Dyadic(q.hit.t)) * squared_length(q.query.rayo.v().xyz()) >= square(distance);
}

}  // namespace durero::conform
