#pragma once
/// Judges what a system claims of a ray, exactly.
///
/// A hit is right where its point may lie on the element that it names (on any, where it names none; of a solid on its
/// wall or its discs) for some data within the declared backward error (verdict.hpp), and no element is met before it
/// by the rays of *all* such data. A hit that says neither a distance nor a point is right where the ray of some such
/// data meets its element, and that of all meets no other before; no number was claimed, so it is never `exact`. A miss
/// is right where no element is met by the rays of all such data, and the origin lies in no closed mesh of a system
/// that claims to be watertight. So whoever computes an exact answer from data that are off by no more is right; that a
/// claim is off is a theorem on every such answer, proved beside conform/shell.hpp, conform/zones.hpp and
/// conform/limits.hpp with exact arithmetic.
///
/// The limits least_t and greatest_t of a profile say what the system need not see. Which rays are judged is decided by
/// the data given: those whose exact first hit is not beyond a limit, or that hit nothing. What is right is decided by
/// all data within the declared backward error: of each the hits beyond a limit may be seen or passed by, so that
/// another hit, or a miss, is right where all that is nearer may be beyond a limit. A hit within the error of a limit
/// is permitted on either side of it; a hit beyond one is right where it is right without the limits.

#include "durero/conform/claim.hpp"
#include "durero/conform/profile.hpp"
#include "durero/conform/suite.hpp"
#include "durero/conform/verdict.hpp"

namespace durero::conform {

/// How the claim on ray number `ray` of the case stands to its truth. Precondition: the case was answered.
Judgement judge(const SuiteCase& of, std::size_t ray, const Claim& claim, const Profile& profile);

/// The clause of the profile that the ray is outside of, or nothing. A ray outside is not asked.
std::string outside(const SuiteCase& of, std::size_t ray, const Profile& profile);

}  // namespace durero::conform
