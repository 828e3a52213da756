#pragma once
/// A bound on the directions of rays between two balls (A §1.6, Ohta and Maekawa): of the rays that start in one and
/// meet the other, none makes a greater angle with the line of the centres than arcsin((r + s)/d), with r and s the
/// radii and d the distance of the centres, where d > r + s.
///
/// Proof. Let the ray go from p in the one ball through q in the other. q − p is the difference of the centres plus a
/// vector of length r + s at most, so its direction is one in which a ball of radius r + s about the one centre is seen
/// from the other. The tangents that cross between the balls attain the bound. By the same argument no q is nearer to
/// its p than d − (r + s).
///
/// Ohta and Maekawa keep lists for each object that a ray may start on, whose number is the square of that of the
/// objects. A source of candidates is not told which object a ray starts on (trace/candidates.hpp), so
/// accel/classification.hpp keeps lists by this bound for balls around boxes of space instead, made only where rays
/// come.

#include "durero/accel/seen.hpp"

namespace durero::accel {

/// The ball `to` as it is seen from all points of the ball `from` together: from its centre, with the radii added.
/// Rounding only makes it greater. Preconditions are those of seen().
ApparentBall seen_from_within(const surface::Ball& from, const surface::Ball& to);

/// Whether a ray of that direction, of length 1 up to 8u, may start in `from` and meet `to`; false only where none
/// does.
bool may_reach(const surface::Ball& from, const glm::dvec3& direction, const surface::Ball& to);

}  // namespace durero::accel
