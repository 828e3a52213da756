#pragma once
/// The surface of a plane: its equation, which is linear, and its ball and box, which are infinite.

#include <limits>

#include "durero/surface/bounds.hpp"
#include "durero/surface/equation.hpp"

namespace durero::surface {

/// q·d (potencia_plano.def.1)
template <class T>
T potencia(const scene::Plane& plane, const Point<T>& w) {
  return dot(from(plane.centro, w), plane.vector);
}

/// @{ The ball and the box of a plane: all of space.
inline Ball ball(const scene::Plane& plane) { return {plane.centro, std::numeric_limits<double>::infinity()}; }
inline Box box(const scene::Plane&) {
  const glm::dvec3 infinite(std::numeric_limits<double>::infinity());
  return {-infinite, infinite};
}
/// @}

}  // namespace durero::surface
