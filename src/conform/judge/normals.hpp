#pragma once
/// The judgement on what a hit says beside its place: the normal, the side and the coordinates on a triangle.
///
/// Each is right where some data within the declared backward error have it at the place that the hit gives. A normal
/// is the direction of a vector that data move by `error` at most; its coordinates are those of a unit vector, and may
/// be off by u = 16ε besides. The errors are derived beside each shape, with δ and the ray's share of allowance.hpp.

#include "conform/judge/trial.hpp"
#include "durero/conform/judge/verdict.hpp"

namespace durero::conform {

/// The verdict on what a hit says beside its place, where the profile claims that: right where all of it is right about
/// one of the elements, on which the place may lie; also where it says nothing.
Verdict verdict_besides(const ClaimContext& trial, const Claim& claim, const ClaimedPoint& place,
                        const std::vector<scene::ElementRef>& at);

}  // namespace durero::conform
