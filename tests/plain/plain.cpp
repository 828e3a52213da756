#include "plain/plain.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace durero::trace::plain {
namespace {

using glm::dvec3;
using model::Resultado;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr First miss{Resultado::miss, 0};

double square(double x) { return x * x; }
double square(const dvec3& x) { return glm::dot(x, x); }

/// What cylinder and cone share: the parts of q0 and v across the axis, and along it.
struct Axial {
  double s0, s1;
  dvec3 a, b;
};

Axial axial(const dvec3& centro, const dvec3& vector, const model::Rayo& rayo) {
  const dvec3 q0 = rayo.p().xyz() - centro;
  const dvec3& v = rayo.v().xyz();
  const double s0 = glm::dot(q0, vector);
  const double s1 = glm::dot(v, vector);
  return {s0, s1, v - s1 * vector, q0 - s0 * vector};
}

bool within(const Quadratic& f, double t) {
  const double s = f.s0 + t * f.s1;
  return t > 0 && 0 <= s && s <= f.altura && f.margin.value_or(0) >= 0;
}

/// The whole line lies in the surface: what the clip leaves of it.
First first_of_line(const Quadratic& f) {
  if (f.s1 == 0) return 0 <= f.s0 && f.s0 <= f.altura ? First{Resultado::no_minimum, 0} : miss;
  const double at_base = -f.s0 / f.s1;
  const double at_top = (f.altura - f.s0) / f.s1;
  const auto [begin, end] = std::minmax(at_base, at_top);
  if (begin > 0) return {Resultado::hit, begin};
  return end > 0 ? First{Resultado::no_minimum, 0} : miss;
}

First first_of_roots(const Quadratic& f, double t, double other) {
  const auto [near, far] = std::minmax(t, other);
  if (within(f, near)) return {Resultado::hit, near};
  return within(f, far) ? First{Resultado::hit, far} : miss;
}

First first_of_element(const scene::Scene& scene, scene::ElementRef e, const model::Rayo& rayo, bool on) {
  return scene.visit(e, [&](const auto& shape) { return first(quadratic(shape, rayo, on)); });
}

/// Algorithm II.2: the nearest so far, and every element that shares it. No minimum stands before every hit.
struct Nearest {
  scene::Hit& hit;

  void take(scene::ElementRef e, const First& found) {
    if (found.resultado == Resultado::miss) return;
    if (hit.resultado != found.resultado && hit.resultado == Resultado::no_minimum) return;
    const bool first_of_kind = hit.resultado != found.resultado;
    if (!first_of_kind && found.t > hit.t) return;
    if (first_of_kind || found.t < hit.t) hit.elementos.clear();
    hit.elementos.push_back(e);
    hit.resultado = found.resultado;
    hit.t = found.t;
  }

  double limit() const { return hit.resultado == Resultado::miss ? infinity : hit.t; }

  void finish(const model::Rayo& rayo) const {
    if (hit.resultado == Resultado::hit) hit.punto = rayo.p().xyz() + hit.t * rayo.v().xyz();
  }
};

}  // namespace

Quadratic quadratic(const scene::Sphere& sphere, const model::Rayo& rayo, bool on) {
  const dvec3 q0 = rayo.p().xyz() - sphere.centro;
  const dvec3& v = rayo.v().xyz();
  const double A = square(v);
  const double B = glm::dot(q0, v);
  const double C = on ? 0 : square(q0) - square(sphere.radio);
  const double D = on ? square(B) : square(sphere.radio) * A - square(glm::cross(q0, v));
  return {A, B, C, D, 0, 0, infinity};
}

Quadratic quadratic(const scene::Cylinder& cylinder, const model::Rayo& rayo, bool on) {
  const auto [s0, s1, a, b] = axial(cylinder.centro, cylinder.vector, rayo);
  const double A = square(a);
  const double B = glm::dot(b, a);
  const double C = on ? 0 : square(b) - square(cylinder.radio);
  const double D = on ? square(B) : square(cylinder.radio) * A - square(glm::cross(b, a));
  return {A, B, C, D, s0, s1, cylinder.altura};
}

Quadratic quadratic(const scene::Cone& cone, const model::Rayo& rayo, bool on) {
  const auto [s0, s1, a, b] = axial(cone.centro, cone.vector, rayo);
  const double k2 = square(cone.proporcion);
  const double g = cone.altura - s0;
  const double A = square(a) - k2 * square(s1);
  const double B = glm::dot(b, a) + k2 * g * s1;
  const double C = on ? 0 : square(b) - k2 * square(g);
  const double D = on ? square(B) : k2 * square(g * a + s1 * b) - square(glm::cross(b, a));
  return {A, B, C, D, s0, s1, cone.altura};
}

Quadratic quadratic(const scene::TruncatedCone& cone, const model::Rayo& rayo, bool on) {
  const auto [s0, s1, a, b] = axial(cone.centro, cone.vector, rayo);
  const double rho = cone.radio + cone.proporcion * (cone.altura - s0), slope = cone.proporcion * s1;
  const double A = square(a) - square(slope);
  const double B = glm::dot(b, a) + rho * slope;
  const double C = on ? 0 : square(b) - square(rho);
  const double D = on ? square(B) : square(rho * a + slope * b) - square(glm::cross(b, a));
  return {A, B, C, D, s0, s1, cone.altura};
}

Quadratic quadratic(const scene::Plane& plane, const model::Rayo& rayo, bool on) {
  const double B = glm::dot(rayo.v().xyz(), plane.vector) / 2;
  const double C = on ? 0 : glm::dot(rayo.p().xyz() - plane.centro, plane.vector);
  return {0, B, C, square(B), 0, 0, infinity};
}

Quadratic quadratic(const scene::Disc& disc, const model::Rayo& rayo, bool on) {
  Quadratic f = quadratic(scene::Plane{disc.centro, disc.vector}, rayo, on);
  const dvec3 q0 = rayo.p().xyz() - disc.centro;
  const double s0 = glm::dot(q0, disc.vector), s1 = 2 * f.B;
  f.margin = disc.radio * std::abs(s1) - glm::length(s1 * q0 - s0 * rayo.v().xyz());
  return f;
}

Quadratic quadratic(const scene::Triangle& triangle, const model::Rayo& rayo, bool on) {
  const auto& [a, b, c] = triangle.vertices;
  const dvec3 e1 = b - a, e2 = c - a, q0 = rayo.p().xyz() - a;
  const dvec3 v_e2 = glm::cross(rayo.v().xyz(), e2), q_e1 = glm::cross(q0, e1);
  const double det = glm::dot(e1, v_e2), side = std::copysign(1, det);
  const double ca = side * glm::dot(q0, v_e2), ab = side * glm::dot(rayo.v().xyz(), q_e1);
  const double C = on ? 0 : glm::dot(e2, q_e1);
  return {0, -det / 2, C, square(det / 2), 0, 0, infinity, std::min({ab, ca, std::abs(det) - ab - ca})};
}

First first(const Quadratic& f) {
  if (f.D < 0) return miss;
  if (f.A == 0 && f.B == 0) return f.C == 0 && !f.margin ? first_of_line(f) : miss;
  // Both terms of q have one sign, so nothing cancels; the roots are q/A and, as their product is C/A, C/q.
  const double S = std::sqrt(f.D), q = -(f.B + (f.B < 0 ? -S : S));
  if (f.A == 0) return first_of_roots(f, f.C / q, f.C / q);
  if (q == 0) return first_of_roots(f, 0, 0);
  return first_of_roots(f, q / f.A, f.C / q);
}

scene::Hit first_hit(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  scene::Hit hit;
  Nearest nearest{hit};
  scene.for_each(
      [&](scene::ElementRef e, const auto& shape) { nearest.take(e, first(quadratic(shape, rayo, en.contains(e)))); });
  nearest.finish(rayo);
  return hit;
}

scene::Hit first_hit(const Tables& tables, const model::Rayo& rayo, Origin en) {
  scene::Hit hit;
  Nearest nearest{hit};
  const Ray ray(rayo);
  tables.any(
      ray, [&] { return nearest.limit(); },
      [&](scene::ElementRef e) {
        nearest.take(e, first_of_element(tables.scene(), e, rayo, en.contains(e)));
        return false;
      });
  nearest.finish(rayo);
  return hit;
}

}  // namespace durero::trace::plain
