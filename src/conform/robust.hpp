#pragma once
/// Whether a crossing stays where data change a little.

#include "conform/candidate.hpp"
#include "durero/conform/truth.hpp"

namespace durero::conform {

/// What a change of the data, however small, may take the crossing at t away by: none, where the root is simple and
/// lies strictly between the bounds of the element, for then the signs that make it one are those of numbers other than
/// 0, which small changes leave as they are. Precondition: t is of reach(c.f).
Ambiguity weakness(const Candidate& c, const Parameter& t);

/// Whether the ray certainly has no point on the element, ends or not: quickly, and no where that is not clear.
bool certainly_missed(const AnsweredQuery& q, scene::ElementRef e);

/// Whether weakness certainly says none of the hit, and it is of one element: quickly, and no where that is not clear.
/// Precondition: the hit is the exact answer to the query.
bool certainly_robust(const AnsweredQuery& q);

/// The truth of an exact answer.
Truth truth_of(const AnsweredQuery& q);

}  // namespace durero::conform
