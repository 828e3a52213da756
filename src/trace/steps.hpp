#pragma once
/// The steps behind the triage of one ray and one element (triage.hpp): double-double with a bound, and what is rounded
/// once. quadratic-inl.hpp holds the forms and their bounds.

#include "durero/scene/shape_view.hpp"
#include "durero/trace/finding.hpp"
#include "durero/trace/ray.hpp"

namespace durero::trace {

/// triage in double-double.
Finding stable(scene::ShapeView element, const Ray& ray, bool on, double limit = no_limit);

/// A finding of the triage improved by one step of Newton's, the quadratic taken in double-double; undecided where the
/// slope may be 0. Precondition: the finding is a hit of this element by triage, for the same `on`.
Finding improved(scene::ShapeView element, const Ray& ray, bool on, const Finding& finding);

/// t and the point of a finding. Precondition: the finding is a hit of this element by stable or improved.
Rounded rounded(scene::ShapeView element, const Ray& ray, const Finding& finding);

}  // namespace durero::trace
