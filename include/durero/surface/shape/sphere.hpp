#pragma once
/// The surface of a sphere: its equation, and what contains it.

#include "durero/surface/bounds.hpp"
#include "durero/surface/equation.hpp"

namespace durero::surface {

/// |q|² − radio² (potencia_esfera.def.1)
template <class T>
auto potencia(const scene::Sphere& sphere, const Point<T>& w) {
  return squared_length(from(sphere.centro, w)) - square(Constant<T>(sphere.radio));
}

/// Precondition of both: every number of the shape is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰.
Ball ball(const scene::Sphere& shape);
Box box(const scene::Sphere& shape);

}  // namespace durero::surface
