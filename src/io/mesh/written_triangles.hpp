#pragma once
/// What the formats of meshes do not keep of a scene, and other formats of triangles neither.

#include <string>
#include <string_view>
#include <vector>

#include "durero/io/formats.hpp"
#include "io/written/by_group.hpp"

namespace durero::io {

/// Adds a line for the groups that lie in others, which `one`, as the format has it, does not.
void add_nesting_loss(std::vector<std::string>& lost, const scene::Groups& groups, std::string_view one);

/// @{ Adds a line for the triangles with normals of their vertices, which are written flat; for those with uv, where
/// the format keeps none; and for those with tangents.
void add_smoothness_loss(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view why);
void add_wrap_losses(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view format,
                     bool keeps_uv = false);
/// @}

/// Adds a line for each kind of thing but triangles, their normals and groups, and their uv where it keeps them: a
/// format of meshes has none of the others.
void add_mesh_losses(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view format,
                     bool keeps_uv = false);

}  // namespace durero::io
