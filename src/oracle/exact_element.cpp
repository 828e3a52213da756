#include "durero/oracle/exact_element.hpp"

#include <utility>

namespace durero::oracle::exact {
namespace {

using number::shifted;
using number::sign;
using number::square;

struct Vec {
  Dyadic x, y, z;
};

Vec vec(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
Dyadic dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Vec difference(const glm::dvec3& a, const glm::dvec3& b) {
  return {Dyadic(a.x) - Dyadic(b.x), Dyadic(a.y) - Dyadic(b.y), Dyadic(a.z) - Dyadic(b.z)};
}

/// The quadratic of alejamiento: |q − s·d|² = q·q − (2 − n)·s² with s = q·d and n = d·d.
struct Axial {
  Dyadic A, B, C, s0, s1;
};

Axial axial(const glm::dvec3& centro, const glm::dvec3& vector, const model::Rayo& rayo, bool on) {
  const Vec q0 = difference(rayo.p().xyz(), centro);
  const Vec v = vec(rayo.v().xyz());
  const Vec d = vec(vector);
  const Dyadic s0 = dot(q0, d);
  const Dyadic s1 = dot(v, d);
  const Dyadic m = Dyadic(2) - dot(d, d);
  const Dyadic m_s1 = m * s1;
  return {dot(v, v) - m_s1 * s1, dot(q0, v) - m_s1 * s0, on ? Dyadic() : dot(q0, q0) - m * square(s0), s0, s1};
}

/// Where avance is the given height. Precondition: s1 ≠ 0.
Parameter at_height(const Coefficients& f, const Dyadic& height) { return {.x = height - f.s0, .w = f.s1}; }

/// A ray inside the surface: the part of it between the two clip planes.
Reach reach_of_line(const Coefficients& f) {
  if (!f.altura) return {.segment = Segment{}};
  if (sign(f.s1) == 0) {
    const bool inside = sign(f.s0) >= 0 && f.s0 <= *f.altura;
    return inside ? Reach{.segment = Segment{}} : Reach{};
  }
  Parameter begin = at_height(f, 0);
  Parameter end = at_height(f, *f.altura);
  if (sign(f.s1) < 0) std::swap(begin, end);
  if (number::sign(end) <= 0) return {};
  if (number::sign(begin) <= 0) return {.segment = Segment{std::nullopt, std::move(end)}};
  return {.segment = Segment{std::move(begin), std::move(end)}};
}

}  // namespace

Coefficients coefficients(const scene::Sphere& sphere, const model::Rayo& rayo, bool on) {
  const Vec q0 = difference(rayo.p().xyz(), sphere.centro);
  const Vec v = vec(rayo.v().xyz());
  const Dyadic C = on ? Dyadic() : dot(q0, q0) - square(Dyadic(sphere.radio));
  return {dot(v, v), dot(q0, v), C, 0, 0, std::nullopt};
}

Coefficients coefficients(const scene::Cylinder& cylinder, const model::Rayo& rayo, bool on) {
  auto [A, B, C, s0, s1] = axial(cylinder.centro, cylinder.vector, rayo, on);
  if (!on) C -= square(Dyadic(cylinder.radio));
  return {A, B, C, s0, s1, cylinder.altura};
}

Coefficients coefficients(const scene::Cone& cone, const model::Rayo& rayo, bool on) {
  auto [A, B, C, s0, s1] = axial(cone.centro, cone.vector, rayo, on);
  const Dyadic k2 = square(Dyadic(cone.proporcion));
  const Dyadic g = Dyadic(cone.altura) - s0;
  const Dyadic k2_s1 = k2 * s1;
  A -= k2_s1 * s1;
  B += k2_s1 * g;
  if (!on) C -= k2 * square(g);
  return {A, B, C, s0, s1, cone.altura};
}

Roots roots(const Coefficients& f) {
  const int of_A = sign(f.A);
  if (of_A == 0) {
    if (sign(f.B) == 0) return {.every = sign(f.C) == 0};
    return {.count = 1, .t = {Parameter{.x = -f.C, .w = shifted(f.B, 1)}}};
  }
  if (sign(f.C) == 0) {
    const Parameter other{.x = shifted(-f.B, 1), .w = f.A};
    const int of_other = number::sign(other);
    if (of_other == 0) return {.count = 1, .t = {other}};
    if (of_other > 0) return {.count = 2, .t = {Parameter{}, other}};
    return {.count = 2, .t = {other, Parameter{}}};
  }
  const Dyadic D = square(f.B) - f.A * f.C;
  const int of_D = sign(D);
  if (of_D < 0) return {};
  if (of_D == 0) return {.count = 1, .t = {Parameter{.x = -f.B, .w = f.A}}};
  return {.count = 2, .t = {Parameter{-f.B, -of_A, D, f.A}, Parameter{-f.B, of_A, D, f.A}}};
}

bool within_clip(const Coefficients& f, const Parameter& t) {
  if (!f.altura) return true;
  return number::sign(number::linear(f.s0, f.s1, t)) >= 0 &&
         number::sign(number::linear(*f.altura - f.s0, -f.s1, t)) >= 0;
}

Reach reach(const Coefficients& f) {
  const Roots found = roots(f);
  if (found.every) return reach_of_line(f);
  Reach result;
  for (const Parameter& t : found.values()) {
    if (number::sign(t) > 0 && within_clip(f, t)) result.t[result.count++] = t;
  }
  return result;
}

}  // namespace durero::oracle::exact
