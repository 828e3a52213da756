#pragma once
/// The surface of a cone: its equation, ball and box.

#include "durero/surface/bounds.hpp"
#include "durero/surface/equation.hpp"

namespace durero::surface {

/// |q − s·d|² − (proporcion·(altura − s))² (potencia_cono.def.1)
template <class T>
auto potencia(const scene::Cone& cone, const Point<T>& w) {
  using C = Constant<T>;
  return alejamiento(cone, w) - square((C(cone.altura) - avance(cone, w)) * C(cone.proporcion));
}

/// @{ The ball and the box of a cone. Precondition: every number of the shape is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰.
inline Ball ball(const scene::Cone& cone) {
  return ball_of_discs(cone.centro, cone.vector, cone.altura, cone.proporcion * cone.altura, 0);
}
inline Box box(const scene::Cone& cone) {
  return box_of_discs(cone.centro, cone.vector, cone.altura, cone.proporcion * cone.altura, 0);
}
/// @}

}  // namespace durero::surface
