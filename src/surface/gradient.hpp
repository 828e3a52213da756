#pragma once
/// The gradient of a shape's potencia at a point.

#include <glm/vec3.hpp>

#include "durero/surface/surfaces.hpp"

namespace durero::surface {

/// The gradient, which is across the surface, towards its outer side.
template <class Shape>
inline glm::dvec3 gradient_of(const Shape& shape, const glm::dvec3& w) {
  using D = Dual<double>;
  const D power = potencia(shape, Point<D>{{w.x, 1, 0, 0}, {w.y, 0, 1, 0}, {w.z, 0, 0, 1}});
  return {power.dx, power.dy, power.dz};
}

}  // namespace durero::surface
