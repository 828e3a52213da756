#pragma once
/// Scene files: JSON, `{"format":"durero-scene","version":1,…,"elementos":[…]}`.

#include <string>
#include <string_view>

#include "durero/io/source.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// Reads a scene. A file is good when it is JSON, has the keys of the format and no others, and every element can be
/// added by its operation; otherwise throws InputError at the first value or key that is wrong, with the label of the
/// clause that it breaks, if it breaks one. Names of materials are any text of at least one character.
scene::Scene read_scene(const Source& source);

/// The canonical text of a scene: the same scene gives the same bytes. Elements stand one a line, ascending by name.
std::string scene_text(const scene::Scene& scene);

}  // namespace durero::io
