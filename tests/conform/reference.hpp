#pragma once
/// The first hit a second time, with nothing of the oracle's: membership as the Z text states it, over the numbers
/// x + y√Δ and rationals. No quadratic is written down; each is found from three values on the ray.
/// Slow, and as plain as it can be.

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "durero/contract/contract.hpp"
#include "durero/number/surd.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/scene.hpp"

namespace durero::test {

using number::Rational;
using number::Surd;

struct RationalPoint {
  Rational x, y, z;
};

/// escalar and lado of the Z text.
inline Rational escalar(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r,
                        const RationalPoint& s) {
  return (q.x - p.x) * (s.x - r.x) + (q.y - p.y) * (s.y - r.y) + (q.z - p.z) * (s.z - r.z);
}
inline Rational lado(const RationalPoint& w, const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  return escalar(a, b, a, b) * escalar(a, w, a, c) - escalar(a, b, a, c) * escalar(a, w, a, b);
}

/// An element as the Z text sees it: potencia of a point, and what must not be negative there.
struct Surface {
  scene::ElementRef e;
  RationalPoint centro, vector;
  Rational radio, proporcion, altura;  ///< the radius at the advance s is radio + proporcion·(altura − s)
  std::array<RationalPoint, 3> vertices;

  static RationalPoint exact(const glm::dvec3& v) {
    return {number::exact(v.x), number::exact(v.y), number::exact(v.z)};
  }

  Rational avance(const RationalPoint& w) const {
    return (w.x - centro.x) * vector.x + (w.y - centro.y) * vector.y + (w.z - centro.z) * vector.z;
  }
  Rational potencia_esfera(const RationalPoint& w) const { return escalar(centro, w, centro, w) - radio * radio; }
  Rational potencia_triangulo(const RationalPoint& w) const {
    const auto& [a, b, c] = vertices;
    return (w.x - a.x) * ((b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y)) +
           (w.y - a.y) * ((b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z)) +
           (w.z - a.z) * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  }
  Rational potencia_axial(const RationalPoint& w) const {
    const Rational s = avance(w);
    const Rational x = w.x - centro.x - s * vector.x, y = w.y - centro.y - s * vector.y,
                   z = w.z - centro.z - s * vector.z;
    const Rational radius = radio + proporcion * (altura - s);
    return x * x + y * y + z * z - radius * radius;
  }
  Rational potencia(const RationalPoint& w) const {
    switch (e.tipo) {
      case model::Tipo::soy_esfera:
        return potencia_esfera(w);
      case model::Tipo::soy_cilindro:
      case model::Tipo::soy_cono:
      case model::Tipo::soy_tronco:
        return potencia_axial(w);
      case model::Tipo::soy_plano:
      case model::Tipo::soy_disco:
        return avance(w);
      case model::Tipo::soy_triangulo:
        return potencia_triangulo(w);
    }
    contract::unreachable();
  }
  /// tramo: the points where none of these is negative.
  std::vector<Rational> bounds(const RationalPoint& w) const {
    const auto& [a, b, c] = vertices;
    switch (e.tipo) {
      case model::Tipo::soy_esfera:
      case model::Tipo::soy_plano:
        return {};
      case model::Tipo::soy_cilindro:
      case model::Tipo::soy_cono:
      case model::Tipo::soy_tronco:
        return {avance(w), altura - avance(w)};
      case model::Tipo::soy_disco:
        return {-potencia_esfera(w)};
      case model::Tipo::soy_triangulo:
        return {lado(w, a, b, c), lado(w, b, c, a), lado(w, c, a, b)};
    }
    contract::unreachable();
  }
};

/// The attributes that the shape has; the others are 0.
template <class Shape>
Surface surface(scene::ElementRef e, const Shape& shape) {
  using number::exact;
  Surface of;
  of.e = e;
  if constexpr (requires { shape.centro; }) of.centro = Surface::exact(shape.centro);
  if constexpr (requires { shape.vector; }) of.vector = Surface::exact(shape.vector);
  if constexpr (requires { shape.radio; }) of.radio = exact(shape.radio);
  if constexpr (requires { shape.proporcion; }) of.proporcion = exact(shape.proporcion);
  if constexpr (requires { shape.altura; }) of.altura = exact(shape.altura);
  if constexpr (requires { shape.vertices; })
    for (std::size_t i = 0; i < 3; ++i) of.vertices[i] = Surface::exact(shape.vertices[i]);
  return of;
}

inline std::vector<Surface> surfaces(const scene::Scene& scene) {
  std::vector<Surface> all;
  scene.for_each([&](scene::ElementRef e, const auto& shape) { all.push_back(surface(e, shape)); });
  return all;
}

/// alcance: the points at t > 0 ascending; or a segment, of which its first point, or no_minimum where it has none.
struct ReferenceReach {
  std::vector<Surd> points{};
  bool no_minimum = false;
};

inline RationalPoint at(const model::Rayo& ray, const Rational& t) {
  const RationalPoint p = Surface::exact(ray.p().xyz()), v = Surface::exact(ray.v().xyz());
  return {p.x + t * v.x, p.y + t * v.y, p.z + t * v.z};
}

/// a·t² + b·t + c.
struct Polynomial {
  Rational a, b, c;

  /// Through three values: a + b at 1 and 4a + 2b at 2, less c.
  Polynomial(const Rational& at_0, const Rational& at_1, const Rational& at_2)
      : a((at_2 - 2 * at_1 + at_0) / 2), b(at_1 - at_0 - a), c(at_0) {}

  Surd operator()(const Surd& t) const { return (Surd(a) * t + Surd(b)) * t + Surd(c); }
  /// Ascending; none where every t is one.
  std::vector<Surd> roots() const {
    if (a == 0 && b == 0) return {};
    if (a == 0) return {Surd(Rational(-c / b))};
    const Rational delta = b * b - 4 * a * c;
    if (delta < 0) return {};
    if (delta == 0) return {Surd(Rational(-b / (2 * a)))};
    const Surd root(0, 1, delta), middle(Rational(-b / (2 * a))), half = root / Surd(Rational(2 * a));
    return {std::min(middle - half, middle + half), std::max(middle - half, middle + half)};
  }
};

/// What bounds the surface, along the ray.
inline std::vector<Polynomial> bounds_along(const Surface& surface, const model::Rayo& ray) {
  const auto at_0 = surface.bounds(at(ray, 0)), at_1 = surface.bounds(at(ray, 1)), at_2 = surface.bounds(at(ray, 2));
  std::vector<Polynomial> all;
  for (std::size_t i = 0; i < at_0.size(); ++i) all.emplace_back(at_0[i], at_1[i], at_2[i]);
  return all;
}

inline bool none_negative(const std::vector<Polynomial>& bounds, const Surd& t) {
  return std::all_of(bounds.begin(), bounds.end(), [&](const Polynomial& of) { return number::sign(of(t)) >= 0; });
}

/// The ray inside the surface: a convex part of it, whose ends are among the roots of the bounds. Before the first root
/// ahead no bound changes its sign; where none is negative there, the ray has points as near to its origin as one
/// likes.
inline ReferenceReach reach_along(const std::vector<Polynomial>& bounds) {
  std::vector<Surd> ends;
  for (const Polynomial& of : bounds) {
    for (const Surd& t : of.roots())
      if (number::sign(t) > 0) ends.push_back(t);
  }
  std::sort(ends.begin(), ends.end());
  const Surd near = ends.empty() ? Surd(1) : ends.front() / Surd(2);
  if (none_negative(bounds, near)) return {{}, true};
  for (const Surd& t : ends)
    if (none_negative(bounds, t)) return {{t}, false};
  return {};
}

inline ReferenceReach reach(const Surface& surface, const model::Rayo& ray, bool on) {
  const Rational at_0 = surface.potencia(at(ray, 0)), less = on ? at_0 : Rational(0);
  const Polynomial power(at_0 - less, surface.potencia(at(ray, 1)) - less, surface.potencia(at(ray, 2)) - less);
  const std::vector<Polynomial> bounds = bounds_along(surface, ray);
  if (power.a == 0 && power.b == 0 && power.c == 0) return reach_along(bounds);
  ReferenceReach found;
  for (const Surd& t : power.roots())
    if (number::sign(t) > 0 && none_negative(bounds, t)) found.points.push_back(t);
  return found;
}

inline scene::Hit reference_first_hit(const scene::Scene& scene, const model::Rayo& ray, const scene::ElementSet& en) {
  std::optional<Surd> nearest;
  scene::ElementSet at_nearest, without_minimum;
  for (const Surface& surface : surfaces(scene)) {
    const bool on = std::find(en.begin(), en.end(), surface.e) != en.end();
    const ReferenceReach found = reach(surface, ray, on);
    if (found.no_minimum) without_minimum.push_back(surface.e);
    if (found.points.empty()) continue;
    if (!nearest || found.points[0] < *nearest) {
      nearest = found.points[0];
      at_nearest.clear();
    }
    if (found.points[0] == *nearest) at_nearest.push_back(surface.e);
  }
  if (!without_minimum.empty()) return {.resultado = model::Resultado::no_minimum, .elementos = without_minimum};
  if (!nearest) return {};
  const auto coordinate = [&](double p, double v) { return number::round_to_binary64(Surd(p) + Surd(v) * *nearest); };
  return {model::Resultado::hit,
          number::round_to_binary64(*nearest),
          {coordinate(ray.p().x(), ray.v().x()), coordinate(ray.p().y(), ray.v().y()),
           coordinate(ray.p().z(), ray.v().z())},
          at_nearest};
}

}  // namespace durero::test
