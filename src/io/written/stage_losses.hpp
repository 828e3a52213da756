#pragma once
/// What no writer of another program's scenes keeps of looks and surroundings.

#include <string>
#include <string_view>
#include <vector>

#include "durero/scene/groups.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// Adds a line for each of textures, environment and max_depth, and for a camera that is missing.
/// `format` is the name of the other format.
void add_stage_losses(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view format);

/// Adds a line for the groups in which no element and no group is.
void add_empty_group_losses(std::vector<std::string>& lost, const scene::Groups& groups);

}  // namespace durero::io
