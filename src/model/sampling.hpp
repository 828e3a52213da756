#pragma once
/// Random members of a surface, exactly: a rational line that crosses the axis at a right angle meets the surface in
/// points whose coordinates are x + y√Δ.

#include <optional>

#include "durero/model/puntos.hpp"
#include "durero/model/quadratic.hpp"
#include "durero/model/schema.hpp"

namespace durero::model {

/// A rational in [0, 1], a multiple of 2⁻¹⁶: both ends are drawn too.
Rational any_share(Random& random);

/// A vector that is not null, with small integer components.
ExactVector any_direction(Random& random);

/// A vector at a right angle to dir, exactly, and not null.
ExactVector any_normal(const Vector& dir, Random& random);

/// A point on the axis through centro, whose advance lies in [0, h].
ExactPoint any_on_axis(const Punto& centro, const Vector& dir, const Rmas& h, Random& random);

/// A member of `set` where the line p + t·v, with p rational, meets the surface of this power; nothing where none is.
template <class Power>
std::optional<ExactPoint> any_crossing(Power&& power, const Puntos::Membership& set, const ExactPoint& p,
                                       const ExactVector& v, Random& random) {
  const RationalQuadratic q = restricted(power, p, v);
  if (q.is_zero()) return std::nullopt;
  std::vector<ExactPoint> members;
  for (const Surd& t : roots(q))
    if (ExactPoint w = along(p, v, t); set(w)) members.push_back(std::move(w));
  if (members.empty()) return std::nullopt;
  return members[random() % members.size()];
}

/// { w | power(w) = 0 ∧ 0 ≤ avance(w, centro, dir) ≤ h }. Precondition: the power of a point of the axis is negative
/// near centro.
Puntos axial_points(const Potencia& power, const Punto& centro, const Vector& dir, const Rmas& h);

}  // namespace durero::model
