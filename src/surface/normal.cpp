#include "durero/surface/normal.hpp"

#include <glm/geometric.hpp>

#include "gradient.hpp"

namespace durero::surface {
namespace {

/// The normal at a point. It is computed for every point of a picture, so all its calls are inlined.
template <class Shape>
[[gnu::flatten]] glm::dvec3 normal_of(const Shape& shape, const glm::dvec3& w) {
  const glm::dvec3 gradient = gradient_of(shape, w);
  if (const double length = glm::length(gradient); length > 0) return gradient / length;
  if constexpr (Axial<Shape>) return shape.vector;
  return {0, 0, 0};
}

}  // namespace

glm::dvec3 normal(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point) {
  return scene.visit(element, [&](const auto& shape) { return normal_of(shape, point); });
}

}  // namespace durero::surface
