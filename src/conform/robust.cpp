#include "conform/robust.hpp"

#include <cmath>

#include "durero/surface/surfaces.hpp"

namespace durero::conform {
namespace {

using number::Ball;
using number::sign;

bool has_zero_bound(const Candidate& c) {
  return std::any_of(c.f.bounds.begin(), c.f.bounds.end(), [](const auto& bound) { return sign(bound.C) == 0; });
}

/// The numbers that t was rounded from. Precondition: t is normal and finite.
Ball unrounded(double t) { return {t, 0x1p-52 * std::abs(t), 0}; }

/// Whether the potencia is quadratic along a ray.
template <class Shape>
concept Curved = requires(const Shape& shape, const surface::Point<surface::Linear<Ball>>& w) { potencia(shape, w).C; };

/// D > 0 and 0 < avance < altura.
template <Curved Shape>
bool is_simple_and_between_ends(const Shape& shape, const model::Rayo& rayo, bool on, double t) {
  const auto w = surface::along<Ball>(rayo);
  const auto f = potencia(shape, w);
  const Ball D = on ? surface::square(f.B) : surface::square(f.B) - f.A * f.C;
  if (D.decided_sign() <= 0) return false;
  if constexpr (surface::Axial<Shape>) {
    const auto s = avance(shape, w);
    const Ball at = s.at_zero + unrounded(t) * s.slope;
    return at.decided_sign() > 0 && (Ball(shape.altura) - at).decided_sign() > 0;
  } else {
    return true;
  }
}

/// There is no root, or none is positive: A, B and C have one sign, or on the surface A and B, whose other root is
/// −2B/A.
template <Curved Shape>
bool has_certainly_no_root_ahead(const Shape& shape, const model::Rayo& rayo, bool on) {
  const auto f = potencia(shape, surface::along<Ball>(rayo));
  const int of_B = f.B.decided_sign();
  const bool have_one_sign = of_B != 0 && f.A.decided_sign() == of_B && (on || f.C.decided_sign() == of_B);
  return have_one_sign || (!on && (surface::square(f.B) - f.A * f.C).decided_sign() < 0);
}

}  // namespace

bool certainly_missed(const AnsweredQuery& q, scene::ElementRef e) {
  return q.scene.visit(e, [&]<class Shape>(const Shape& shape) {
    if constexpr (Curved<Shape>)
      return has_certainly_no_root_ahead(shape, q.query.rayo, scene::Origin(q.query.en).contains(e));
    else
      return surface::exact::reach(q.scene, e, q.query.rayo, q.query.en).empty();  // it looks quickly first
  });
}

Ambiguity weakness(const Candidate& c, const Parameter& t) {
  if (roots(c.f).every) return Ambiguity::in_surface;
  if (c.is_at_end(t)) return has_apex(c.e.tipo) && c.sign_beyond(t) == 0 ? Ambiguity::apex : Ambiguity::rim;
  if (has_zero_bound(c)) return c.e.tipo == model::Tipo::soy_triangulo ? Ambiguity::edge : Ambiguity::rim;
  return !c.is_flat() && sign(c.f.A) != 0 && sign(c.discriminant()) == 0 ? Ambiguity::tangent : Ambiguity::none;
}

bool certainly_robust(const AnsweredQuery& q) {
  if (!hits(q) || q.hit.elementos.size() > 1 || !std::isnormal(q.hit.t)) return false;
  const scene::ElementRef e = q.hit.elementos.front();
  const bool on = scene::Origin(q.query.en).contains(e);
  return q.scene.visit(e, [&]<class Shape>(const Shape& shape) {
    if constexpr (Curved<Shape>) {
      return is_simple_and_between_ends(shape, q.query.rayo, on, q.hit.t);
    } else {
      const Candidate c = candidate(q, e);
      return sign(c.f.B) != 0 && !has_zero_bound(c);
    }
  });
}

}  // namespace durero::conform
