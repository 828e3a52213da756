#pragma once
/// The reduction of a failure to the smallest case that still fails, which is the first thing that a system's author
/// wants to see.

#include "durero/conform/ask/runner.hpp"
#include "durero/conform/report/tally.hpp"

namespace durero::conform {

/// The finding with the fewest elements and the roundest numbers for which the system still fails as badly: with the
/// same verdict, and gross where the finding is gross. Elements are left out; the scene is moved to the origin and
/// scaled by a power of two; axes become those of the coordinates; then each number becomes 0, a power of two, or keeps
/// only its first bits. Of more than 32 elements that are needed none is changed. The exact judge judges each step that
/// is kept: no failure is believed because it is near.
Finding minimised(const Finding& finding, const Profile& profile, const Ask& ask);

/// The finding with the fewest elements, moved to the origin and of a size and a direction near 1 where the system
/// still fails with the same verdict; its other numbers are as they were. It takes few questions.
Finding tidied(const Finding& finding, const Profile& profile, const Ask& ask);

}  // namespace durero::conform
