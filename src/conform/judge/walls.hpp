#pragma once
/// The zones of one ray that the system on trial must see.

#include "conform/judge/trial.hpp"

namespace durero::conform {

/// The zones of elements up to `limit` that a hit must not lie behind, and that make a miss wrong: all zones within the
/// limits of the profile and the range of the ray, but for backs that the system may leave unseen. Zones of solids that
/// a ray from inside may leave unseen are left out.
std::vector<Zone> walls_of_elements(const ClaimContext& trial, double limit);

/// The zone of a closed mesh, within limits and range likewise, where the system claims to be watertight.
std::optional<Zone> wall_of_mesh(const ClaimContext& trial);

/// Both together.
std::vector<Zone> walls(const ClaimContext& trial, double limit);

}  // namespace durero::conform
