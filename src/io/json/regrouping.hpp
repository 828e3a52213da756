#pragma once
/// The edits that make the groups of one scene those of another.

#include <vector>

#include "durero/scene/groups.hpp"

namespace durero::io {

/// The fewest edits, in order: groups are dissolved, then made from small to large. Precondition: the elements of both
/// are elements of one scene.
std::vector<scene::GroupEdit> regrouping(const scene::Groups& from, const scene::Groups& to);

}  // namespace durero::io
