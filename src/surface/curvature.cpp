#include "durero/surface/curvature.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "gradient.hpp"

namespace durero::surface {
namespace {

/// Each potencia is a polynomial of the second degree, whose gradient is linear in the point: its matrix has the
/// columns of half a difference.
template <class Shape>
glm::dmat3 curvature_of(const Shape& shape, const glm::dvec3& w) {
  const glm::dvec3 gradient = gradient_of(shape, w);
  const double length = glm::length(gradient);
  if (!(length > 0)) return glm::dmat3(0);
  glm::dmat3 turns(0);
  for (int i = 0; i < 3; ++i) {
    glm::dvec3 step(0);
    step[i] = 1;
    turns[i] = 0.5 * (gradient_of(shape, w + step) - gradient_of(shape, w - step));
  }
  const glm::dvec3 n = gradient / length;
  const glm::dmat3 along = glm::dmat3(1) - glm::outerProduct(n, n);
  return along * turns * along / length;
}

}  // namespace

glm::dmat3 curvature(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point) {
  return scene.visit(element, [&](const auto& shape) { return curvature_of(shape, point); });
}

}  // namespace durero::surface
