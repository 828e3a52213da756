#pragma once
/// The errors of a hit, for the report. Of these only is_far(), is_near_surface() and is_near_origin() take part in a
/// verdict: they tell a gross error of a wrong hit from a small one.

#include "conform/judge/trial.hpp"

namespace durero::conform {

/// Whether the place is further than 0.001 of the size from the truth's point, for each element of the truth. The size
/// is the radius of a sphere or a disc, the larger of altura and the base's radius of a shape with an axis, the longest
/// edge of a triangle, and the distance t!·|v| to a plane. A place is far from a point with an infinite t.
/// Precondition: the truth is no miss.
bool is_far(const ClaimContext& trial, const ClaimedPoint& place);
/// Whether the place is within 0.001 of the element's size of its surface, up to a few roundings of binary64.
bool is_near_surface(const ClaimContext& trial, const ClaimedPoint& place, scene::ElementRef element);
/// Whether the place is within 0.001 of the element's size of the ray's origin.
bool is_near_origin(const ClaimContext& trial, const ClaimedPoint& place, scene::ElementRef element);

/// The error of a number, in units of the last place of the right one, rounded to the format.
double error_in_ulps(double claimed, double right, NumberFormat format);
/// The errors of a claimed hit as ClaimJudgement::ulps and ClaimJudgement::backward define them.
double ulps(const ClaimContext& trial, const Claim& claim, const ClaimedPoint& place);
double backward_error(const ClaimContext& trial, const Claim& claim, const ClaimedPoint& place);
/// The backward error of a place near the truth's point, by binary64 and so more quickly: the component across the
/// surface of the step between the two points. It is off by 1 at most, for that point is rounded. Precondition: the
/// claim may name an element of the truth.
double backward_error_near_truth(const ClaimContext& trial, const Claim& claim, const ClaimedPoint& place);

}  // namespace durero::conform
