#pragma once
/// The elements of a scene in the order in which other programs' formats have them.

#include <string>
#include <string_view>
#include <vector>

#include "durero/scene/groups.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// An element, and the group that it is directly in; the empty name where it is in none.
struct GroupedElement {
  scene::ElementRef element;
  std::string_view group;
  std::string name;
};

/// The elements by group, then by name; a number that ends a name counts as a number, so that `m:2` stands before
/// `m:10` and a file that was read and is written again has its order. They refer to the scene and its groups.
std::vector<GroupedElement> elements_by_group(const scene::Scene& scene, const scene::Groups& groups);

/// @{ The triangles alone, and all others, in the same order.
std::vector<GroupedElement> triangles_by_group(const scene::Scene& scene, const scene::Groups& groups);
std::vector<GroupedElement> others_by_group(const scene::Scene& scene, const scene::Groups& groups);
/// @}

}  // namespace durero::io
