#pragma once
/// What a failure hangs on, as it is tried and not guessed: variations of its question that change little to the eye.

#include <string>
#include <vector>

#include "durero/conform/runner.hpp"
#include "durero/conform/tally.hpp"

namespace durero::conform {

/// A question beside that of a failure, and what the system answers to it.
struct Variation {
  std::string what;  ///< such as "with v/|v| for v"
  Finding answered;  ///< the varied question, the claim on it and its judgement, a failure or not
};

/// With a v of unit length, with the whole scene of a size near 1, with an origin nearer to the first point: those that
/// change something, and that the profile covers.
std::vector<Variation> variations(const Finding& finding, const Profile& profile, const Ask& ask);

/// "With v/|v| for v it is right." or "… it is missed as well.", of a variation of a failure with that verdict.
std::string variation_text(const Variation& variation, Verdict verdict);

}  // namespace durero::conform
