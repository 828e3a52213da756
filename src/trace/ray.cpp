#include "durero/trace/ray.hpp"

#include "trace/range.hpp"

namespace durero::trace {

Ray::Ray(const model::Rayo& rayo)
    : p(rayo.p().xyz()),
      v(rayo.v().xyz()),
      speed(speed_of(rayo.v().xyz())),
      ordinary(ray_in_range<DoublePairs>(rayo.p().xyz(), rayo.v().xyz())) {}

bool ordinary(scene::ShapeView element) {
  return element.visit([]<class Shape>(const Shape& shape) {
    return shape_in_range<DoublePairs, Shape>(
        [&](const auto& attribute) -> const auto& { return shape.*attribute.field; });
  });
}

}  // namespace durero::trace
