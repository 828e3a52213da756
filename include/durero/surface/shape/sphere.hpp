#pragma once
/// The surface of a sphere: its equation, ball and box.

#include <cmath>
#include <limits>

#include "durero/surface/bounds.hpp"
#include "durero/surface/equation.hpp"

namespace durero::surface {

/// |q|² − radio² (potencia_esfera.def.1; along a ray, cuadratica_esfera.def.1)
template <class T>
auto potencia(const scene::Sphere& sphere, const Point<T>& w) {
  return squared_length(from(sphere.centro, w)) - square(Constant<T>(sphere.radio));
}

/// The ball of a sphere. Precondition of both: every number of the shape is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰.
inline Ball ball(const scene::Sphere& sphere) { return {sphere.centro, sphere.radio}; }
/// The box of a sphere. A difference is rounded once, so its neighbour lies beyond the exact one.
inline Box box(const scene::Sphere& sphere) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box{};
  for (int i = 0; i < 3; ++i) {
    box.low[i] = std::nextafter(sphere.centro[i] - sphere.radio, -infinity);
    box.high[i] = std::nextafter(sphere.centro[i] + sphere.radio, infinity);
  }
  return box;
}

}  // namespace durero::surface
