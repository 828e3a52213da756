#pragma once
/// Whether a crossing stays where data change a little.

#include "conform/candidate.hpp"
#include "durero/conform/truth.hpp"

namespace durero::conform {

/// What a change of the data, however small, may take the crossing at t away by: none, where the root is simple and
/// lies strictly between the bounds of the element, for then the signs that make it one are those of numbers other than
/// 0, which small changes leave as they are. Precondition: t is of reach(c.f).
Ambiguity weakness(const Candidate& c, const Parameter& t);

/// A number of binary64 that t is at most: a limit that leaves out nothing up to t.
double rounded_up(const Parameter& t);

}  // namespace durero::conform
