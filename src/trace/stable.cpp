#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/stable.cpp"  // as seen from src/
#include <hwy/foreach_target.h>
//
#include "durero/trace/closed_form-inl.hpp"
#include "durero/trace/steps.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {
namespace {

template <class Element>
Finding stable_of(const Element& element, const Beam& beam, bool on, double limit) {
  return published(closed_form<DoubleDouble>(element, beam, on, limit));
}

Finding stable_sphere(const scene::Sphere& e, const Beam& b, bool on, double limit) {
  return stable_of(e, b, on, limit);
}
Finding stable_cylinder(const scene::Cylinder& e, const Beam& b, bool on, double limit) {
  return stable_of(e, b, on, limit);
}
Finding stable_cone(const scene::Cone& e, const Beam& b, bool on, double limit) { return stable_of(e, b, on, limit); }

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::trace {
namespace {

HWY_EXPORT(stable_sphere);
HWY_EXPORT(stable_cylinder);
HWY_EXPORT(stable_cone);

}  // namespace

Finding stable(const scene::Sphere& e, const Beam& b, bool on, double limit) {
  return HWY_DYNAMIC_DISPATCH(stable_sphere)(e, b, on, limit);
}
Finding stable(const scene::Cylinder& e, const Beam& b, bool on, double limit) {
  return HWY_DYNAMIC_DISPATCH(stable_cylinder)(e, b, on, limit);
}
Finding stable(const scene::Cone& e, const Beam& b, bool on, double limit) {
  return HWY_DYNAMIC_DISPATCH(stable_cone)(e, b, on, limit);
}

}  // namespace durero::trace
#endif
