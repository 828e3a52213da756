#pragma once
/// Scenes and JSON Patch (RFC 6902): a patch is a JSON array of operations on the canonical text of a scene.

#include <string>
#include <string_view>

#include "durero/io/source.hpp"
#include "durero/scene/grouped_scene.hpp"

namespace durero::io {

/// The patch that changes nothing.
inline constexpr std::string_view empty_patch = "[]\n";

/// The patch that makes one scene of another, whatever they differ in: an operation a line, empty_patch where they are
/// the same. Before an element or a mesh is changed or removed, whose place in the text is a number, a test asks its
/// id.
std::string scene_patch(const scene::GroupedScene& from, const scene::GroupedScene& to);

/// The scene that a patch makes of another; all of its operations are carried out, or it throws InputError: at a place
/// in the patch, where it is none, where a pointer leads nowhere, where a test fails, or where the document that it
/// makes is no scene: then at its beginning, with the pointer to what is wrong.
scene::GroupedScene patched_scene(const scene::GroupedScene& scene, const Source& patch);

}  // namespace durero::io
