#include "members.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "durero/surface/exact.hpp"

namespace durero::conform {
namespace {

using model::Resultado;
using model::Tipo;
using number::Dyadic;
using number::sign;
using number::square;
using scene::ElementRef;
using surface::exact::Coefficients;
using surface::exact::Parameter;

struct Vec {
  Dyadic x, y, z;
};
Vec vec(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
Vec difference(const glm::dvec3& a, const glm::dvec3& b) {
  return {Dyadic(a.x) - Dyadic(b.x), Dyadic(a.y) - Dyadic(b.y), Dyadic(a.z) - Dyadic(b.z)};
}
Dyadic dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(const Vec& a, const Vec& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Dyadic magnitude(const Dyadic& x) { return sign(x) < 0 ? -x : x; }
Dyadic squared_length(const glm::dvec3& v) { return dot(vec(v), vec(v)); }

/// |part| is at most 2⁻²⁰ of the whole.
bool negligible(const Dyadic& part, const Dyadic& whole) {
  return number::shifted(magnitude(part), 20) <= magnitude(whole);
}

/// An element of a scene, and the ray's quadratic on it.
struct Seen {
  ElementRef e;
  glm::dvec3 centro;
  double radius;  ///< of a cone, proporcion
  glm::dvec3 vector;
  double altura;
  Coefficients f;

  bool is_axial() const { return e.tipo != Tipo::soy_esfera; }
  /// The radius, of a cone at its base.
  Dyadic size() const { return e.tipo == Tipo::soy_cono ? Dyadic(radius) * Dyadic(altura) : Dyadic(radius); }
};

Seen seen(const Ray_And_Hit& r, ElementRef e, bool on) {
  switch (e.tipo) {
    case Tipo::soy_esfera: {
      const scene::Sphere& s = r.scene.shapes<scene::Sphere>()[e.index];
      return {e, s.centro, s.radio, {}, 0, surface::exact::coefficients(s, r.ray.rayo, on)};
    }
    case Tipo::soy_cilindro: {
      const scene::Cylinder& c = r.scene.shapes<scene::Cylinder>()[e.index];
      return {e, c.centro, c.radio, c.vector, c.altura, surface::exact::coefficients(c, r.ray.rayo, on)};
    }
    default: {
      const scene::Cone& c = r.scene.shapes<scene::Cone>()[e.index];
      return {e, c.centro, c.proporcion, c.vector, c.altura, surface::exact::coefficients(c, r.ray.rayo, on)};
    }
  }
}

Seen seen(const Ray_And_Hit& r, ElementRef e) {
  return seen(r, e, std::find(r.ray.en.begin(), r.ray.en.end(), e) != r.ray.en.end());
}

template <class Holds>
bool any_element(const Ray_And_Hit& r, Holds holds) {
  const auto in = [&](Tipo tipo, std::size_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      if (holds(seen(r, {tipo, i}))) return true;
    }
    return false;
  };
  return in(Tipo::soy_esfera, r.scene.shapes<scene::Sphere>().size()) ||
         in(Tipo::soy_cilindro, r.scene.shapes<scene::Cylinder>().size()) ||
         in(Tipo::soy_cono, r.scene.shapes<scene::Cone>().size());
}

template <class Holds>
bool any_hit_element(const Ray_And_Hit& r, Holds holds) {
  return hits(r) &&
         std::any_of(r.hit.elementos.begin(), r.hit.elementos.end(), [&](ElementRef e) { return holds(seen(r, e)); });
}

/// Precondition: the ray hits this element first.
Parameter first(const Seen& s) { return reach(s.f).first(); }

/// t·|v| ≥ distance, for t as it is rounded.
bool travels_at_least(const Ray_And_Hit& r, const Dyadic& distance) {
  if (!std::isfinite(r.hit.t)) return true;
  return square(Dyadic(r.hit.t)) * squared_length(r.ray.rayo.v().xyz()) >= square(distance);
}

Dyadic discriminant(const Coefficients& f) { return square(f.B) - f.A * f.C; }

double rounded_avance(const Coefficients& f, const Parameter& t) {
  return number::round_to_binary64(number::linear(f.s0, f.s1, t));
}

/// avance at t is exactly 0 or altura.
bool at_end(const Seen& s, const Parameter& t) {
  return s.is_axial() && (number::sign(number::linear(s.f.s0, s.f.s1, t)) == 0 ||
                          number::sign(number::linear(s.f.s0 - *s.f.altura, s.f.s1, t)) == 0);
}

template <class Holds>
bool any_root_ahead(const Seen& s, Holds holds) {
  const surface::exact::Roots found = roots(s.f);
  const auto values = found.values();
  return std::any_of(values.begin(), values.end(), [&](const Parameter& t) { return number::sign(t) > 0 && holds(t); });
}

}  // namespace

bool hits(const Ray_And_Hit& r) { return r.hit.resultado == Resultado::hit; }

bool coincides(const Ray_And_Hit& r) {
  if (r.hit.resultado == Resultado::no_minimum || tie(r)) return true;
  return any_element(r, [](const Seen& s) {
    const Coefficients& f = s.f;
    if (sign(f.A) == 0 || sign(f.B) == 0 || sign(f.C) == 0 || (s.is_axial() && sign(f.s1) == 0)) return true;
    return sign(discriminant(f)) == 0 || any_root_ahead(s, [&](const Parameter& t) { return at_end(s, t); });
  });
}

bool from_far(const Ray_And_Hit& r) {
  return any_hit_element(r, [&](const Seen& s) {
    const Vec q = difference(r.ray.rayo.p().xyz(), s.centro);
    return dot(q, q) >= square(Dyadic(1000) * s.size());
  });
}

bool far_from_zero(const Ray_And_Hit& r) {
  return any_hit_element(r, [](const Seen& s) {
    const double farthest = std::max({std::abs(s.centro.x), std::abs(s.centro.y), std::abs(s.centro.z)});
    return Dyadic(farthest) >= Dyadic(1000) * s.size();
  });
}

bool hits_far(const Ray_And_Hit& r) { return hits(r) && travels_at_least(r, 1e6); }

bool hits_tiny(const Ray_And_Hit& r) {
  return any_hit_element(r, [](const Seen& s) { return s.size() <= Dyadic(1e-3); });
}

bool sizes_differ(const Ray_And_Hit& r) {
  return any_hit_element(r, [&](const Seen& one) {
    return any_element(r, [&](const Seen& other) {
      const Dyadic ratio(1e6);
      return one.size() >= ratio * other.size() || other.size() >= ratio * one.size();
    });
  });
}

bool long_or_short(const Ray_And_Hit& r) {
  const Dyadic square_of_v = squared_length(r.ray.rayo.v().xyz());
  return hits(r) && (square_of_v > Dyadic(0x1p16) || square_of_v < Dyadic(0x1p-16));
}

bool beyond_binary32(const Ray_And_Hit& r) {
  return any_hit_element(
      r, [](const Seen& s) { return square(s.size()) >= Dyadic(0x1p128) || square(s.size()) < Dyadic(0x1p-126); });
}

bool beyond_binary64(const Ray_And_Hit& r) {
  return any_hit_element(r, [](const Seen& s) {
    return square(s.size()) >= number::shifted(1, 1024) || square(s.size()) < Dyadic(0x1p-1022);
  });
}

bool long_and_thin(const Ray_And_Hit& r) {
  return any_hit_element(r, [](const Seen& s) { return Dyadic(s.altura) >= Dyadic(1000) * s.size(); });
}

bool nearly_axial(const Ray_And_Hit& r) {
  return any_element(r, [&](const Seen& s) {
    const Vec v = vec(r.ray.rayo.v().xyz()), out = cross(v, vec(s.vector));
    return s.e.tipo == Tipo::soy_cilindro && number::shifted(dot(out, out), 40) <= dot(v, v);
  });
}

bool axial(const Ray_And_Hit& r) {
  return any_element(r, [&](const Seen& s) {
    const Vec out = cross(vec(r.ray.rayo.v().xyz()), vec(s.vector));
    return s.e.tipo == Tipo::soy_cilindro && sign(dot(out, out)) == 0;
  });
}

bool perpendicular(const Ray_And_Hit& r) {
  return any_hit_element(r, [](const Seen& s) { return s.is_axial() && sign(s.f.s1) == 0; });
}

bool nearly_generator(const Ray_And_Hit& r) {
  return any_element(
      r, [&](const Seen& s) { return s.is_axial() && negligible(s.f.A, squared_length(r.ray.rayo.v().xyz())); });
}

bool generator(const Ray_And_Hit& r) {
  return any_element(r, [](const Seen& s) { return s.is_axial() && sign(s.f.A) == 0; });
}

bool aligned(const Ray_And_Hit& r) {
  const auto none = [](double x) { return std::abs(x) < std::numeric_limits<double>::min(); };
  const glm::dvec3& v = r.ray.rayo.v().xyz();
  return hits(r) && (none(v.x) || none(v.y) || none(v.z));
}

bool exactly_aligned(const Ray_And_Hit& r) {
  const glm::dvec3& v = r.ray.rayo.v().xyz();
  return hits(r) && (v.x == 0 || v.y == 0 || v.z == 0);
}

bool mirrored_first(const Ray_And_Hit& r) {
  if (r.hit.resultado == Resultado::no_minimum) return false;
  return any_element(r, [&](const Seen& s) {
    return s.e.tipo == Tipo::soy_cono && any_root_ahead(s, [&](const Parameter& t) {
             const bool beyond = number::sign(number::linear(s.f.s0 - *s.f.altura, s.f.s1, t)) > 0;
             return beyond && (!hits(r) || surface::exact::order(t, first(seen(r, r.hit.elementos[0]))) < 0);
           });
  });
}

bool nearly_apex(const Ray_And_Hit& r) {
  return any_element(r, [&](const Seen& s) {
    if (s.e.tipo != Tipo::soy_cono) return false;
    const Vec apex{Dyadic(s.centro.x) + Dyadic(s.altura) * Dyadic(s.vector.x),
                   Dyadic(s.centro.y) + Dyadic(s.altura) * Dyadic(s.vector.y),
                   Dyadic(s.centro.z) + Dyadic(s.altura) * Dyadic(s.vector.z)};
    const Vec p = vec(r.ray.rayo.p().xyz()), v = vec(r.ray.rayo.v().xyz());
    const Vec to{apex.x - p.x, apex.y - p.y, apex.z - p.z}, out = cross(to, v);
    return sign(dot(to, v)) > 0 && number::shifted(dot(out, out), 40) <= square(Dyadic(s.altura)) * dot(v, v);
  });
}

bool apex(const Ray_And_Hit& r) {
  // On a cone with avance = altura the point is at the distance 0 from the axis.
  return any_hit_element(r, [](const Seen& s) {
    return s.e.tipo == Tipo::soy_cono && number::sign(number::linear(s.f.s0 - *s.f.altura, s.f.s1, first(s))) == 0;
  });
}

bool nearly_rim(const Ray_And_Hit& r) {
  return any_element(r, [](const Seen& s) {
    return s.is_axial() && any_root_ahead(s, [&](const Parameter& t) {
             const double at = rounded_avance(s.f, t);
             const bool other_rim = s.e.tipo == Tipo::soy_cilindro && std::abs(s.altura - at) <= 0x1p-20 * s.altura;
             return std::abs(at) <= 0x1p-20 * s.altura || other_rim;
           });
  });
}

bool rim(const Ray_And_Hit& r) {
  return any_hit_element(r, [&](const Seen& s) { return at_end(s, first(s)) && !apex(r); });
}

bool inside(const Ray_And_Hit& r) {
  return any_hit_element(r, [](const Seen& s) {
    return sign(s.f.C) < 0 && (!s.is_axial() || (sign(s.f.s0) >= 0 && s.f.s0 <= *s.f.altura));
  });
}

bool starts_on(const Ray_And_Hit& r) {
  return !r.ray.en.empty() || any_element(r, [](const Seen& s) {
    return negligible(s.f.C, square(s.size())) && (!s.is_axial() || (sign(s.f.s0) >= 0 && s.f.s0 <= *s.f.altura));
  });
}

bool starts_exactly_on(const Ray_And_Hit& r) {
  return any_element(r, [&](const Seen& s) {
    return sign(seen(r, s.e, false).f.C) == 0 && (!s.is_axial() || (sign(s.f.s0) >= 0 && s.f.s0 <= *s.f.altura));
  });
}

bool hits_near(const Ray_And_Hit& r) {
  return any_hit_element(r, [&](const Seen& s) { return !travels_at_least(r, Dyadic(1e-3) * s.size()); });
}

bool nearly_tangent(const Ray_And_Hit& r) {
  return any_element(r, [](const Seen& s) {
    return sign(s.f.A) != 0 && sign(s.f.B * s.f.A) < 0 && negligible(discriminant(s.f), square(s.f.B));
  });
}

bool tangent(const Ray_And_Hit& r) {
  return any_hit_element(r, [](const Seen& s) { return sign(s.f.A) != 0 && sign(discriminant(s.f)) == 0; });
}

bool nearly_zero_b(const Ray_And_Hit& r) {
  return any_hit_element(r,
                         [](const Seen& s) { return number::shifted(square(s.f.B), 40) <= magnitude(s.f.A * s.f.C); });
}

bool zero_b(const Ray_And_Hit& r) {
  return any_hit_element(r, [](const Seen& s) { return sign(s.f.B) == 0; });
}

bool nearly_tie(const Ray_And_Hit& r) {
  if (!hits(r)) return false;
  return any_element(r, [&](const Seen& s) {
    if (s.e == r.hit.elementos[0]) return false;
    const surface::exact::Reach found = reach(s.f);
    return !found.empty() && !found.no_minimum() && number::round_to_binary64(found.first()) <= r.hit.t * (1 + 0x1p-20);
  });
}

bool tie(const Ray_And_Hit& r) { return hits(r) && r.hit.elementos.size() > 1; }

bool nearly_in_surface(const Ray_And_Hit& r) {
  const Dyadic square_of_v = squared_length(r.ray.rayo.v().xyz());
  return any_element(r, [&](const Seen& s) {
    return s.is_axial() && negligible(s.f.A, square_of_v) &&
           number::shifted(square(s.f.B), 20) <= square_of_v * square(s.size()) &&
           negligible(s.f.C, square(s.size()) + square(s.f.s0));
  });
}

bool in_surface(const Ray_And_Hit& r) {
  return r.hit.resultado == Resultado::no_minimum ||
         any_hit_element(r, [](const Seen& s) { return reach(s.f).segment.has_value(); });
}

bool on_grid(const Ray_And_Hit& r) {
  const auto snapped = [](double x) { return std::abs(x) <= 8 && std::floor(4 * x) == 4 * x; };
  const glm::dvec3 &p = r.ray.rayo.p().xyz(), &v = r.ray.rayo.v().xyz();
  return snapped(p.x) && snapped(p.y) && snapped(p.z) && snapped(v.x) && snapped(v.y) && snapped(v.z);
}

}  // namespace durero::conform
