#pragma once
/// Judges what a system claims of a ray, exactly.

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
