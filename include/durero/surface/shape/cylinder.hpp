#pragma once
/// The surface of a cylinder: its equation, and what contains it.

#include "durero/surface/bounds.hpp"
#include "durero/surface/equation.hpp"

namespace durero::surface {

/// |q − s·d|² − radio² (potencia_cilindro.def.1)
template <class T>
auto potencia(const scene::Cylinder& cylinder, const Point<T>& w) {
  return alejamiento(cylinder, w) - square(Constant<T>(cylinder.radio));
}

/// @{ What contains every point of it. Precondition: every number of the shape is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰.
inline Ball ball(const scene::Cylinder& cylinder) {
  return ball_of_discs(cylinder.centro, cylinder.vector, cylinder.altura, cylinder.radio, cylinder.radio);
}
inline Box box(const scene::Cylinder& cylinder) {
  return box_of_discs(cylinder.centro, cylinder.vector, cylinder.altura, cylinder.radio, cylinder.radio);
}
/// @}

}  // namespace durero::surface
