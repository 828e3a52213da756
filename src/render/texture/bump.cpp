#include "durero/render/texture/bump.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "durero/render/light/directions.hpp"

namespace durero::render {

glm::dvec3 normal_of_relief(const Tangents& t, const glm::dvec3& n, const glm::dvec2& slope) {
  return glm::cross(t.u + slope.x * n, t.v + slope.y * n);
}

glm::dvec3 bumped(const Tangents& t, const glm::dvec3& n, const glm::dvec2& slope) {
  const glm::dvec3 plain = glm::cross(t.u, t.v);
  if (slope == glm::dvec2(0) || plain == glm::dvec3(0)) return n;
  const glm::dvec3 relief = normal_of_relief(t, n, slope);
  const bool is_finite = std::isfinite(relief.x) && std::isfinite(relief.y) && std::isfinite(relief.z);
  if (!is_finite || relief == glm::dvec3(0)) return n;
  // A mirrored texture turns its tangents over, and not the surface.
  return unit(glm::dot(plain, n) < 0 ? -relief : relief);
}

}  // namespace durero::render
