#include "durero/scene/solids.hpp"

#include <glm/common.hpp>

namespace durero::scene {

Body unmoved(const AnyShape& shape) { return {Instance{shape, model::identity()}}; }

std::optional<Compound> box_between(const glm::dvec3& a, const glm::dvec3& b) {
  Compound box{Compound::Operation::intersected, {}};
  const glm::dvec3 low = glm::min(a, b), high = glm::max(a, b);
  for (int axis = 0; axis < 3; ++axis) {
    if (!(low[axis] < high[axis])) return std::nullopt;
    glm::dvec3 normal(0);
    normal[axis] = -1;
    box.parts.push_back(unmoved(Plane{low, normal}));
    normal[axis] = 1;
    box.parts.push_back(unmoved(Plane{high, normal}));
  }
  return box;
}

}  // namespace durero::scene
