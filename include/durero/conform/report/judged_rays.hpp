#pragma once
/// The verdicts on a user's own rays, ray by ray.

#include <span>
#include <string>

#include "durero/conform/ask/claims_file.hpp"
#include "durero/conform/judge/judge.hpp"

namespace durero::conform {

/// The counts of the verdicts in a line, then each ray that is off or skipped, with what was expected. Precondition:
/// the case was answered, and has as many rays as claims and judgements.
std::string judged_rays_text(const SuiteCase& of, std::span<const Claim> claims,
                             std::span<const ClaimJudgement> judgements);

/// A line of JSON for each ray, {"ray":0,"verdict":"exact"}: `expected` and `got` where it is off, `clause` where it is
/// skipped, `ulps` and `backward` where they are not 0. Precondition: that of judged_rays_text.
std::string judged_rays_json(const SuiteCase& of, std::span<const Claim> claims,
                             std::span<const ClaimJudgement> judgements);

}  // namespace durero::conform
