#pragma once
/// The limits of a profile on the distance, least_t and greatest_t: what they leave of the crossings of a ray.
///
/// A limit is held against what the system computes, and so against the answer of moved data. Of what the data given
/// say it only decides which rays are judged at all: those whose exact first hit is not beyond it.

#include "conform/trial.hpp"

namespace durero::conform {

/// Whether the number of the exact first hit is beyond a limit.
bool is_truth_beyond_limits(const Trial& trial);

/// Whether all that the ray of the data given meets is beyond a limit: then they have a miss as their answer too. Where
/// it meets a stretch of a surface, no.
bool is_all_beyond_limits(const Trial& trial);

/// The profile, but for its limits.
Profile without_limits(Profile profile);

/// Whether the meeting of the zone is at no distance beyond a limit, whatever the data. A system may pass by any other.
///
/// The ray of all data meets the zone's element at some begin ≤ t ≤ end, in the parameter of its own v. So t·|v| of
/// those data is off by √3·δ, for v; it is rounded once to the system's format, and so is the limit, by √3/16·δ each
/// where they are near one another, for δ is 16ε·M at least, and no coordinate of t·v is larger than M. Together less
/// than 2δ, in t less than 2δ/|v|.
bool is_within_limits(const Trial& trial, const Zone& zone);

}  // namespace durero::conform
