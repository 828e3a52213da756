#pragma once
/// A variation is a question that differs little from that of a failure; the answers to several show by trial on what
/// the failure depends.

#include <string>
#include <vector>

#include "durero/conform/ask/runner.hpp"
#include "durero/conform/report/tally.hpp"

namespace durero::conform {

/// A varied question, and the system's answer to it.
struct Variation {
  std::string what;  ///< such as "with v/|v| for v"
  Finding answered;  ///< the varied question, the claim on it and its judgement, a failure or not
};

/// The variations that change something and that the profile covers: v of unit length, the whole scene of a size near
/// 1, the origin nearer to the first point.
std::vector<Variation> variations(const Finding& finding, const Profile& profile, const Ask& ask);

/// The variation in a sentence, "With v/|v| for v it is right." or "… it is missed as well.", for a failure with that
/// verdict.
std::string variation_text(const Variation& variation, Verdict verdict);

}  // namespace durero::conform
