#include "durero/render/bump.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "durero/render/directions.hpp"

namespace durero::render {

glm::dvec3 normal_of_relief(const Tangents& t, const glm::dvec3& n, const glm::dvec2& slope) {
  return glm::cross(t.u + slope.x * n, t.v + slope.y * n);
}

glm::dvec3 bumped(const Tangents& t, const glm::dvec3& n, const glm::dvec2& slope) {
  if (slope == glm::dvec2(0) || glm::cross(t.u, t.v) == glm::dvec3(0)) return n;
  const glm::dvec3 relief = normal_of_relief(t, n, slope);
  const bool is_finite = std::isfinite(relief.x) && std::isfinite(relief.y) && std::isfinite(relief.z);
  return is_finite && relief != glm::dvec3(0) ? unit(relief) : n;
}

}  // namespace durero::render
