#pragma once
/// The judgement on the first touch of a ball that is cast.
///
/// With δ and u of allowance.hpp the middle p + t·v of the ball is off by 2√3·δ, its radius R by δ, and a claimed t is
/// rounded, by 0.22·δ; M counts R among the lengths. Each point of a moved element is within h·δ of a point of the
/// element, and the other way round (reach_of_errors.hpp); for a plane, which has no such h, |q·d| is off by √3·δ for
/// centro and, since |q| ≤ 3√3·M, by 9·δ for d: 11·δ. So the distance of the middle from the element, less R, is off by
/// less than (h + 5)·δ: η.
///
/// At t the ball of some data may touch only where the element is within R + η of p + t·v, and the balls of *all* data
/// touch where it is within R − η. The first touch of all data then lies between the first t of the one kind and the
/// first of the other, which are the ends of a zone (zones.hpp). A claimed t is right where the ball of some data may
/// touch the element there, and no zone certainly ends before. A t that was computed from a length is off besides, and
/// the distance with it, by as many δ as zones.hpp says. A miss is right where there is no zone.
///
/// A claimed place of contact lies on the element moved by some data, and as far as R from the middle, up to 5·δ: h·δ
/// and, for its own rounding, √3/16·δ make (h + 1)·δ. Where the ball may begin in touch it is as far as R at most.

#include "conform/judge/trial.hpp"
#include "durero/conform/judge/verdict.hpp"

namespace durero::conform {

/// The judgement on a first touch. Precondition: the claim is a hit or a miss.
ClaimJudgement judgement_of_cast(const ClaimContext& trial, const Claim& claim);

/// Whether the ball of some data touches an element before it moves. Precondition: a ball is cast.
bool may_begin_in_touch(const ClaimContext& trial);

}  // namespace durero::conform
