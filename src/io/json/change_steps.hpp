#pragma once
/// The steps of a script that change elements, and that move them between groups.

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "durero/scene/grouped_scene.hpp"
#include "element_steps.hpp"

namespace durero::io {

/// Whether two points have the same text.
bool is_written_alike(const glm::dvec3& a, const glm::dvec3& b);

/// Whether two elements of a name have the same of what no operation gives: motion, normals and uv; none is a body.
bool has_same_rest(const scene::Scene& from, const scene::Scene& to, const std::string& name);

/// The steps that make an element of one scene that of the same name in the other: a change for each attribute that
/// differs, and one of the material. Precondition: has_same_rest(), and both are of one type.
std::vector<AnyStep> changes_between(const scene::Scene& from, const scene::Scene& to, const std::string& name);

/// The moves of elements between groups that both have, or into none; `groups` becomes what they make of it.
std::vector<AnyStep> element_moves(scene::Groups& groups, const scene::Groups& to);

}  // namespace durero::io
