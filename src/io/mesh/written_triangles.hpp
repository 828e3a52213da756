#pragma once
/// The triangles of a scene in the order in which the formats of meshes write them, and what these do not keep.

#include <string>
#include <string_view>
#include <vector>

#include "durero/io/formats.hpp"

namespace durero::io {

/// A triangle, and the group that it is directly in; the empty name where it is in none.
struct WrittenTriangle {
  scene::ElementRef element;
  std::string_view group;
  std::string name;
};

/// The triangles by group, then by name; a number that ends a name counts as a number, so that `m:2` stands before
/// `m:10` and a file that was read and is written again has its order. They refer to the scene and its groups.
std::vector<WrittenTriangle> written_triangles(const scene::Scene& scene, const scene::Groups& groups);

/// Adds a line for the groups that lie in others, which `one`, as the format has it, does not.
void add_nesting_loss(std::vector<std::string>& lost, const scene::Groups& groups, std::string_view one);

/// Adds a line for each kind of thing but triangles, their normals and groups, and their uv where it keeps them: a
/// format of meshes has none of the others.
void add_mesh_losses(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view format,
                     bool keeps_uv = false);

}  // namespace durero::io
