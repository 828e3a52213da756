#include "durero/surface/normal.hpp"

#include <glm/geometric.hpp>

#include "durero/surface/surfaces.hpp"

namespace durero::surface {
namespace {

/// The normal at a point. It is computed for every point of a picture, so all its calls are inlined.
template <class Shape>
[[gnu::flatten]] glm::dvec3 normal_of(const Shape& shape, const glm::dvec3& w) {
  using D = Dual<double>;
  const D power = potencia(shape, Point<D>{{w.x, 1, 0, 0}, {w.y, 0, 1, 0}, {w.z, 0, 0, 1}});
  const glm::dvec3 gradient(power.dx, power.dy, power.dz);
  if (const double length = glm::length(gradient); length > 0) return gradient / length;
  if constexpr (Axial<Shape>) return shape.vector;
  return {0, 0, 0};
}

}  // namespace

glm::dvec3 normal(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point) {
  return scene.visit(element, [&](const auto& shape) { return normal_of(shape, point); });
}

}  // namespace durero::surface
