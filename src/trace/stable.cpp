#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/stable.cpp"  // as seen from src/
#include <hwy/foreach_target.h>
//
#include "durero/trace/closed_form-inl.hpp"
#include "durero/trace/steps.hpp"

#ifndef DURERO_TRACE_STABLE_KERNELS
#define DURERO_TRACE_STABLE_KERNELS
namespace durero::trace {

struct StableKernels {
  Finding (*sphere)(const scene::Sphere&, const Beam&, bool, double);
  Finding (*cylinder)(const scene::Cylinder&, const Beam&, bool, double);
  Finding (*cone)(const scene::Cone&, const Beam&, bool, double);
};

}  // namespace durero::trace
#endif

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {
namespace {

template <class Element>
Finding stable_of(const Element& element, const Beam& beam, bool on, double limit) {
  return published(closed_form<DoubleDouble>(element, beam, on, limit));
}

StableKernels table() { return {stable_of<scene::Sphere>, stable_of<scene::Cylinder>, stable_of<scene::Cone>}; }

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::trace {
namespace {

HWY_EXPORT(table);

/// Chosen once, for the machine at hand.
const StableKernels& kernels() {
  static const StableKernels chosen = HWY_DYNAMIC_DISPATCH(table)();
  return chosen;
}

}  // namespace

Finding stable(const scene::Sphere& e, const Beam& b, bool on, double limit) {
  return kernels().sphere(e, b, on, limit);
}
Finding stable(const scene::Cylinder& e, const Beam& b, bool on, double limit) {
  return kernels().cylinder(e, b, on, limit);
}
Finding stable(const scene::Cone& e, const Beam& b, bool on, double limit) { return kernels().cone(e, b, on, limit); }

}  // namespace durero::trace
#endif
