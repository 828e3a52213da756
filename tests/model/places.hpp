#pragma once
/// Points beside a point of a surface.

#include "durero/model/puntos.hpp"

namespace durero::test {

using model::ExactPoint;
using model::Punto;
using model::Surd;
using model::Vector;

/// w moved away from its foot on the axis through centro by 2⁻²⁰⁰ of its distance, at the same advance where dir is a
/// unit vector.
inline ExactPoint off(const ExactPoint& w, const ExactPoint& foot) {
  const Surd stretch(model::Rational(1 + number::exact(0x1p-200)));
  return {foot.x + stretch * (w.x - foot.x), foot.y + stretch * (w.y - foot.y), foot.z + stretch * (w.z - foot.z)};
}

/// The foot of w on the line through centro.
inline ExactPoint foot_of(const ExactPoint& w, const Punto& centro, const Vector& dir) {
  return along(centro, dir, avance(w, centro, dir));
}

/// The point of the line through centro with this advance, where dir is exactly a unit vector.
inline ExactPoint on_axis(const Punto& centro, const Vector& dir, const Surd& s) { return along(centro, dir, s); }

}  // namespace durero::test
