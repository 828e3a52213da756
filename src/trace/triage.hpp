#pragma once
/// The triage decides one ray and one element in binary64 with a bound. It says hit or miss only where it has proved
/// it. quadratic-inl.hpp holds the closed forms and their bounds.

#include "durero/trace/finding.hpp"
#include "durero/trace/ray.hpp"
#include "trace/closed_form-inl.hpp"

namespace durero::trace {

/// The first point of the ray on the element, or a miss: no point at all, or none at a parameter ≤ limit. `on`: the ray
/// starts on the element. Precondition: element and ray are ordinary. The function is a template, because it is called
/// for every candidate where the type is known.
template <class Shape>
RootEstimate triage(const Shape& element, const Ray& ray, bool on, double limit = no_limit) {
  return HWY_NAMESPACE::published(HWY_NAMESPACE::closed_form<double>(element, ray, on, limit));
}

}  // namespace durero::trace
