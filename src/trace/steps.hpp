#pragma once
/// The steps behind the triage (triage.hpp) for one ray and one element: double-double with a bound, and rounding once.
/// quadratic-inl.hpp holds the closed forms and their bounds.

#include "durero/scene/shape_view.hpp"
#include "durero/trace/finding.hpp"
#include "durero/trace/ray.hpp"

namespace durero::trace {

/// The triage's closed form in double-double.
RootEstimate stable(scene::ShapeView element, const Ray& ray, bool on, double limit = no_limit);

/// Improves a finding by one step of Newton's, with the quadratic in double-double; undecided where the slope may be 0.
/// Precondition: the finding is a hit of this element by triage, for the same `on`.
RootEstimate improved(scene::ShapeView element, const Ray& ray, bool on, const RootEstimate& finding);

/// t and the point of a finding. Precondition: the finding is a hit of this element by stable or improved.
RoundedPoint rounded(scene::ShapeView element, const Ray& ray, const RootEstimate& finding);

}  // namespace durero::trace
