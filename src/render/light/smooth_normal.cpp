#include "smooth_normal.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "durero/render/light/directions.hpp"
#include "durero/render/texture/coordinates.hpp"

namespace durero::render {

glm::dvec3 smooth_normal(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point,
                         const glm::dvec3& n) {
  const auto normals = scene.vertex_normals(element);
  if (!normals) return n;
  const auto [u, v] = own_coordinates(scene, element, point);
  const auto& [a, b, c] = *normals;
  const glm::dvec3 between = unit((1 - u - v) * a + u * b + v * c);
  const double towards = glm::dot(between, n);
  if (!std::isfinite(towards)) return n;
  return towards < 0 ? -between : between;
}

}  // namespace durero::render
