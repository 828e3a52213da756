#pragma once
/// How far off a hit is: figures for the report. They decide nothing but whether what is off is far.

#include "conform/trial.hpp"

namespace durero::conform {

/// Whether the place is further than 0.001 of the size of the element from the truth's point: of the radius of a sphere
/// or a disc, of altura or the radius of the base of one with an axis (the larger), of the longest edge of a triangle,
/// of the way to a plane. Precondition: the truth is no miss.
bool is_far(const Trial& trial, const Place& place);

/// Judgement::ulps and Judgement::backward.
double ulps(const Trial& trial, const Claim& claim, const Place& place);
double backward_error(const Trial& trial, const Claim& claim, const Place& place);

}  // namespace durero::conform
