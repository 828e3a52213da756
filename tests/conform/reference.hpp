#pragma once
/// The first hit a second time, with nothing of the oracle's: membership as the Z text states it, over the numbers
/// x + y√Δ and rationals. The quadratic is not written down but found from three values of `potencia` on the ray.
/// Slow, and as plain as it can be.

#include <optional>
#include <vector>

#include "durero/number/surd.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/scene.hpp"

namespace durero::test {

using number::Rational;
using number::Surd;

struct RationalPoint {
  Rational x, y, z;
};

/// An element as the Z text sees it: potencia and avance of a point.
struct Surface {
  scene::ElementRef e;
  RationalPoint centro, vector;
  Rational radio, proporcion, altura;  ///< the radius at the advance s is radio + proporcion·(altura − s)

  static RationalPoint exact(const glm::dvec3& v) {
    return {number::exact(v.x), number::exact(v.y), number::exact(v.z)};
  }

  Rational avance(const RationalPoint& w) const {
    return (w.x - centro.x) * vector.x + (w.y - centro.y) * vector.y + (w.z - centro.z) * vector.z;
  }
  bool is_bounded() const { return e.tipo != model::Tipo::soy_esfera && e.tipo != model::Tipo::soy_plano; }
  Rational potencia(const RationalPoint& w) const {
    if (e.tipo == model::Tipo::soy_plano) return avance(w);
    const Rational s = e.tipo == model::Tipo::soy_esfera ? Rational(0) : avance(w);
    const Rational x = w.x - centro.x - s * vector.x, y = w.y - centro.y - s * vector.y,
                   z = w.z - centro.z - s * vector.z;
    const Rational radius = radio + proporcion * (altura - s);
    return x * x + y * y + z * z - radius * radius;
  }
};

inline std::vector<Surface> surfaces(const scene::Scene& scene) {
  std::vector<Surface> all;
  const auto e = [&](model::Tipo tipo, std::size_t i) {
    return scene::ElementRef{tipo, static_cast<std::uint32_t>(i)};
  };
  using model::Tipo;
  using number::exact;
  for (std::size_t i = 0; i < scene.shapes<scene::Sphere>().size(); ++i) {
    const scene::Sphere& s = scene.shapes<scene::Sphere>()[i];
    all.push_back({e(Tipo::soy_esfera, i), Surface::exact(s.centro), {}, exact(s.radio), 0, 0});
  }
  for (std::size_t i = 0; i < scene.shapes<scene::Cylinder>().size(); ++i) {
    const scene::Cylinder& c = scene.shapes<scene::Cylinder>()[i];
    all.push_back({e(Tipo::soy_cilindro, i), Surface::exact(c.centro), Surface::exact(c.vector), exact(c.radio), 0,
                   exact(c.altura)});
  }
  for (std::size_t i = 0; i < scene.shapes<scene::Cone>().size(); ++i) {
    const scene::Cone& c = scene.shapes<scene::Cone>()[i];
    all.push_back({e(Tipo::soy_cono, i), Surface::exact(c.centro), Surface::exact(c.vector), 0, exact(c.proporcion),
                   exact(c.altura)});
  }
  for (std::size_t i = 0; i < scene.shapes<scene::TruncatedCone>().size(); ++i) {
    const scene::TruncatedCone& c = scene.shapes<scene::TruncatedCone>()[i];
    all.push_back({e(Tipo::soy_tronco, i), Surface::exact(c.centro), Surface::exact(c.vector), exact(c.radio),
                   exact(c.proporcion), exact(c.altura)});
  }
  for (std::size_t i = 0; i < scene.shapes<scene::Plane>().size(); ++i) {
    const scene::Plane& c = scene.shapes<scene::Plane>()[i];
    all.push_back({e(Tipo::soy_plano, i), Surface::exact(c.centro), Surface::exact(c.vector), 0, 0, 0});
  }
  return all;
}

/// alcance: the points at t > 0 ascending; or from `segment` on, where nothing means t → 0⁺.
struct ReferenceReach {
  std::vector<Surd> points{};
  bool no_minimum = false;
};

inline RationalPoint at(const model::Rayo& ray, const Rational& t) {
  const RationalPoint p = Surface::exact(ray.p().xyz()), v = Surface::exact(ray.v().xyz());
  return {p.x + t * v.x, p.y + t * v.y, p.z + t * v.z};
}

/// 0 ≤ avance ≤ altura at t.
inline bool in_tramo(const Surface& surface, const model::Rayo& ray, const Surd& t) {
  if (!surface.is_bounded()) return true;
  const Rational s0 = surface.avance(at(ray, 0)), s1 = surface.avance(at(ray, 1)) - s0;
  const Surd s = Surd(s0) + Surd(s1) * t;
  return number::sign(s) >= 0 && s <= Surd(surface.altura);
}

/// The ray inside the surface: the values of t where it passes the ends of the stretch, the lesser being the first.
inline ReferenceReach reach_along(const Surface& surface, const model::Rayo& ray) {
  if (!surface.is_bounded()) return {{}, true};
  const Rational s0 = surface.avance(at(ray, 0)), s1 = surface.avance(at(ray, 1)) - s0;
  if (s1 == 0) return {{}, s0 >= 0 && s0 <= surface.altura};
  const Rational to_base = -s0 / s1, to_top = (surface.altura - s0) / s1;
  const Rational first = std::min(to_base, to_top), last = std::max(to_base, to_top);
  if (last <= 0) return {};
  if (first <= 0) return {{}, true};
  return {{Surd(first)}, false};
}

inline ReferenceReach reach(const Surface& surface, const model::Rayo& ray, bool on) {
  const Rational at_0 = surface.potencia(at(ray, 0));
  const Rational at_1 = surface.potencia(at(ray, 1)) - at_0, at_2 = surface.potencia(at(ray, 2)) - at_0;
  // potencia = a·t² + b·t + c: a + b at 1 and 4a + 2b at 2, less c.
  const Rational a = (at_2 - 2 * at_1) / 2, b = at_1 - a, c = on ? Rational(0) : at_0;
  std::vector<Surd> roots;
  if (a == 0 && b == 0) {
    if (c == 0) return reach_along(surface, ray);
  } else if (a == 0) {
    roots = {Surd(Rational(-c / b))};
  } else if (const Rational delta = b * b - 4 * a * c; delta >= 0) {
    const Surd root(0, 1, delta), middle(Rational(-b / (2 * a))), half = root / Surd(Rational(2 * a));
    roots = {middle - half, middle + half};
    if (roots[1] < roots[0]) std::swap(roots[0], roots[1]);
    if (roots[1] == roots[0]) roots.pop_back();
  }
  ReferenceReach found;
  for (const Surd& t : roots)
    if (number::sign(t) > 0 && in_tramo(surface, ray, t)) found.points.push_back(t);
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
