#pragma once
/// The judgement on a list of all hits of a ray, and on their number.
///
/// A list is right where the rays of some data within the allowance may have it. Each hit lies on an element that it
/// may name, as a first hit must. Each zone that the system must see, and so each crossing that all data have, is
/// claimed by a hit of its own. No stretch of an element's shell has more hits than meetings with the rays of any data,
/// and none is nearer than a hit before it in the list. A list that breaks one of these is the answer of no data.
///
/// A number of hits is right where it is no less than that of the zones, and no more than all stretches have room for.

#include "conform/judge/trial.hpp"
#include "durero/conform/judge/verdict.hpp"

namespace durero::conform {

/// The judgement on a list. Precondition: the claim is a hit or a miss.
ClaimJudgement judgement_of_all(const ClaimContext& trial, const Claim& claim);

/// The verdict on the number of hits. Precondition: the claim has one, or is a miss.
Verdict verdict_of_count(const ClaimContext& trial, const Claim& claim);

}  // namespace durero::conform
