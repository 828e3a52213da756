#include "trace/closed_form-inl.hpp"
#include "trace/steps.hpp"

namespace durero::trace {

Finding triage(scene::ShapeView element, const Ray& ray, bool on, double limit) {
  return element.visit([&](const auto& shape) {
    return HWY_NAMESPACE::published(HWY_NAMESPACE::closed_form<double>(shape, ray, on, limit));
  });
}

}  // namespace durero::trace
