#pragma once
/// The judgement on the nearest point of a scene and its distance.
///
/// An answer is right where some data within the allowance may have it: its point lies on the element that it names, or
/// on some; it is so far from the point asked as the answer says; that is the distance from the element, up to what
/// data move it; and it is no more than the distance from the nearest element of the data given, likewise. Of a sphere,
/// a plane, a disc and a triangle the point is besides where the nearest is, to first order.
///
/// With δ and u of allowance.hpp a point that is asked is off by √3·δ, and one that is answered by √3·δ/16, its
/// rounding: by 1.84·δ together. The distance itself is rounded, to δ/16. Each point of a moved element is within h·δ
/// of a point of the element, and the other way round, so that distances move by (h + √3 + 1/8)·δ, less than (h + 2)·δ,
/// roundings of the program's own distance included; for a plane, which has no such h, this is the error of the
/// distance. h is derived beside each shape. A limit of the profile is compared with the distance that the system
/// computes, and rounded to its format by δ/16 where the two are near one another, for which (h + 2)·δ has room, too.

#include "conform/judge/trial.hpp"
#include "durero/conform/judge/verdict.hpp"

namespace durero::conform {

/// The judgement on a nearest point. Precondition: the claim is a hit or a miss.
ClaimJudgement judgement_of_closest(const ClaimContext& trial, const Claim& claim);

}  // namespace durero::conform
