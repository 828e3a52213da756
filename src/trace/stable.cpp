#define HWY_TARGET_INCLUDE "trace/stable.cpp"  // as seen from src/
#include "lanes/for_each_target.hpp"
//
#include "trace/closed_form-inl.hpp"
#include "trace/steps.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {
namespace {

RootEstimate stable_of(scene::ShapeView element, const Ray& ray, bool on, double limit) {
  return element.visit([&](const auto& shape)
                           HWY_ATTR { return published(closed_form<DoubleDouble>(shape, ray, on, limit)); });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::trace {
namespace {
HWY_EXPORT(stable_of);
}  // namespace

RootEstimate stable(scene::ShapeView element, const Ray& ray, bool on, double limit) {
  return HWY_DYNAMIC_DISPATCH(stable_of)(element, ray, on, limit);
}

}  // namespace durero::trace
#endif
