#include "durero/trace/ray.hpp"

#include "trace/range.hpp"

namespace durero::trace {

Ray::Ray(const glm::dvec3& from, const glm::dvec3& along)
    : RayNumbers{from, along, speed_of(along)}, ordinary(ray_in_range<DoublePairs>(from, along)) {}

bool ordinary(scene::ShapeView element) {
  return element.visit([]<class Shape>(const Shape& shape) {
    return shape_in_range<DoublePairs, Shape>(
        [&](const auto& attribute) -> const auto& { return shape.*attribute.field; });
  });
}

}  // namespace durero::trace
