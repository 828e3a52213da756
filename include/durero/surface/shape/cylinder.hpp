#pragma once
/// The surface of a cylinder: its equation, ball and box.

#include "durero/surface/bounds.hpp"
#include "durero/surface/equation.hpp"

namespace durero::surface {

/// |q − s·d|² − radio² (potencia_cilindro.def.1)
template <class T>
auto potencia(const scene::Cylinder& cylinder, const Point<T>& w) {
  return alejamiento(cylinder, w) - square(Constant<T>(cylinder.radio));
}

/// @{ The ball and the box of a cylinder. Precondition: every number of the shape is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰.
inline Ball ball(const scene::Cylinder& cylinder) {
  return ball_of_discs(cylinder.centro, cylinder.vector, cylinder.altura, cylinder.radio, cylinder.radio);
}
inline Box box(const scene::Cylinder& cylinder) {
  return box_of_discs(cylinder.centro, cylinder.vector, cylinder.altura, cylinder.radio, cylinder.radio);
}
/// @}

}  // namespace durero::surface
