#pragma once
/// The certified steps of one ray and one element: triage (binary64 with a bound) and stable (double-double with a
/// bound). Each says hit or miss only where it has proved it. quadratic-inl.hpp holds the forms and their bounds.

#include "durero/scene/shape_view.hpp"
#include "durero/trace/finding.hpp"
#include "durero/trace/ray.hpp"

namespace durero::trace {

/// The first point of the ray on the element, or a miss: no point at all, or none at a parameter ≤ limit.
/// on: the ray starts on the element. Precondition: element and ray are ordinary.
Finding triage(scene::ShapeView element, const Ray& ray, bool on, double limit = no_limit);

/// The same in double-double.
Finding stable(scene::ShapeView element, const Ray& ray, bool on, double limit = no_limit);

/// A finding of the triage improved by one step of Newton's, the quadratic taken in double-double; undecided where the
/// slope may be 0. Precondition: the finding is a hit of this element by triage, for the same `on`.
Finding improved(scene::ShapeView element, const Ray& ray, bool on, const Finding& finding);

/// t and the point of a finding. Precondition: the finding is a hit by stable or improved.
Rounded rounded(const Ray& ray, const Finding& finding);

}  // namespace durero::trace
