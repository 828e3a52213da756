#pragma once
/// The coherence of rays between two balls (A §1.6, Ohta and Maekawa): of the rays that start in one and meet the
/// other, none makes a greater angle with the line of their centres than arcsin((r + s)/d), r and s their radii and d
/// the distance of the centres, where d > r + s.
///
/// For let the ray go from p in the one through q in the other. q − p is the difference of the centres but for a vector
/// of length r + s at most, and the directions of all such vectors are those in which a ball of that radius about the
/// one centre is seen from the other. The tangents that cross between the balls attain the bound. As well, no q is
/// nearer to its p than d − (r + s).
///
/// Ohta and Maekawa keep lists for each object that a ray may start on: as many as there are objects, squared. Here a
/// source of candidates is not told what a ray starts on (trace/candidates.hpp), and the lists by this bound are those
/// of accel/classification.hpp, for balls about boxes of space in place of the objects, and made only where rays come.

#include "durero/accel/seen.hpp"

namespace durero::accel {

/// Where a ball is seen from all points of another together: from its centre, where it is greater by its radius.
/// Rounded to the side that sees more. Preconditions: as of seen().
Seen seen_from_within(const surface::Ball& from, const surface::Ball& to);

/// False only where no ray of that direction, of length 1 up to 8u, starts in the one ball and meets the other.
bool may_reach(const surface::Ball& from, const glm::dvec3& direction, const surface::Ball& to);

}  // namespace durero::accel
