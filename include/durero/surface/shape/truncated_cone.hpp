#pragma once
/// The surface of a truncated cone: its equation, ball and box.

#include "durero/surface/bounds.hpp"
#include "durero/surface/equation.hpp"

namespace durero::surface {

/// |q − s·d|² − (radio + proporcion·(altura − s))² (potencia_tronco.def.1; along a ray, cuadratica_tronco.def.1)
template <class T>
auto potencia(const scene::TruncatedCone& e, const Point<T>& w) {
  using C = Constant<T>;
  const C at_centre = C(e.radio) + C(e.proporcion) * C(e.altura);
  return alejamiento(e, w) - square(at_centre - avance(e, w) * C(e.proporcion));
}

/// The radius at the centre, rounded.
inline double radius_of_base(const scene::TruncatedCone& e) { return e.radio + e.proporcion * e.altura; }

/// @{ The ball and the box of a truncated cone. Precondition: every number of the shape is 0 or of magnitude 2⁻¹⁰⁰ …
/// 2¹⁰⁰.
inline Ball ball(const scene::TruncatedCone& e) {
  return ball_of_discs(e.centro, e.vector, e.altura, radius_of_base(e), e.radio);
}
inline Box box(const scene::TruncatedCone& e) {
  return box_of_discs(e.centro, e.vector, e.altura, radius_of_base(e), e.radio);
}
/// @}

}  // namespace durero::surface
