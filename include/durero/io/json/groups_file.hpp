#pragma once
/// The groups of a scene file: what it has under the key `groups`, of which read_scene() sees whether it is right.

#include <string>

#include "durero/io/json/scene_file.hpp"
#include "durero/io/json/written_elements.hpp"
#include "durero/io/source.hpp"
#include "durero/scene/grouped_scene.hpp"

namespace durero::io {

/// The groups of a file, which may name groups that stand below them; none where it has no such key. Precondition: the
/// scene is what read_scene(source) gives. Throws InputError as that does.
scene::Groups read_groups(const Source& source, const scene::Scene& scene);

/// The content of a scene file; a copy of a group is a group. Throws InputError as read_scene() does.
scene::GroupedScene read_grouped_scene(const Source& source, Bodies bodies = Bodies::refused);

/// The canonical text of a scene and of groups of its elements: the same bytes for the same scene and groups. Without
/// groups that of scene_text(scene).
std::string scene_text(const scene::Scene& scene, const scene::Groups& groups);
/// The same of a scene whose elements are in part of types that a Z text declares: those are written as they are read.
std::string scene_text(const scene::Scene& scene, const scene::Groups& groups, const WrittenPart& written);

}  // namespace durero::io
