#pragma once
/// A failure made as small as it stays one: what a system's author wants to see first.

#include "durero/conform/runner.hpp"
#include "durero/conform/tally.hpp"

namespace durero::conform {

/// The finding with the fewest elements and the roundest numbers for which the system still fails as badly: gross
/// where the finding is gross, and of the same verdict. Elements are left out; the scene is moved to the origin and
/// scaled by a power of two; axes become those of the coordinates; then each number becomes 0, a power of two, or keeps
/// only its first bits. What is kept is judged by the same exact judge: nothing is believed because it is near.
Finding minimised(const Finding& finding, const Profile& profile, const Ask& ask);

}  // namespace durero::conform
