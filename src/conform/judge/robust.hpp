#pragma once
/// The stability of a crossing: whether it remains where the data change a little.

#include "conform/families/candidate.hpp"
#include "durero/conform/judge/truth.hpp"

namespace durero::conform {

/// The reason why an arbitrarily small change of the data may remove the crossing at t. It is `none` where the root is
/// simple and lies strictly between the bounds of the element: the signs that make the crossing are then signs of
/// numbers other than 0, which small changes keep. Precondition: t is of reach(c.f).
Ambiguity weakness(const ElementQuadratic& c, const Parameter& t);

/// A binary64 number no less than t, or infinity: a limit that leaves out nothing up to t.
double rounded_up(const Parameter& t);

}  // namespace durero::conform
