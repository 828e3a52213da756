#pragma once
/// The limits least_t and greatest_t of a profile, the range of a ray, and the crossings that they leave.
///
/// A limit is compared with the number that the system computes, and so with the answer of moved data. The data given
/// decide only which rays are judged at all: rays whose exact first hit is not beyond a limit.

#include "conform/judge/trial.hpp"

namespace durero::conform {

/// Whether the number of the exact first hit is beyond a limit.
bool is_truth_beyond_limits(const ClaimContext& trial);

/// Whether every crossing of the ray of the data given is beyond a limit: a miss is then an answer of these data too. A
/// stretch inside a surface counts as within the limits.
bool is_all_beyond_limits(const ClaimContext& trial);

/// The profile with its limits lifted.
Profile without_limits(Profile profile);

/// Whether no data put the crossing of the zone beyond a limit. A system may pass by any other crossing.
///
/// The ray of all data meets the zone's element at some begin ≤ t ≤ end, in the parameter of its own v. The distance
/// t·|v| of those data is off by √3·δ, for v; it is rounded once to the system's format, and the limit as well, by
/// √3/16·δ each where they are near one another, for δ is 16ε·M at least, and no coordinate of t·v is larger than M.
/// Together this is less than 2δ, in t less than 2δ/|v|.
bool is_within_limits(const ClaimContext& trial, const Zone& zone);

/// Whether no data put the crossing of the zone outside the range of the ray, if it has one. Its ends are t, and their
/// errors are those of limits.
bool is_within_range(const ClaimContext& trial, const Zone& zone);

/// Whether some data may put a place on the element within the range of the ray, if it has one. The error of an end is
/// that of a limit; the t of the place is off by its own.
bool may_be_within_range(const ClaimContext& trial, scene::ElementRef element, const ClaimedPoint& place);

/// A lower bound on the meetings of the element and the ray of any data within the range, as earliest() is without one;
/// nothing where no such ray meets it there. The error of an end is that of a limit, with δ of the element at the end.
std::optional<surface::exact::Parameter> earliest_asked(const ClaimContext& trial, scene::ElementRef element);

}  // namespace durero::conform
