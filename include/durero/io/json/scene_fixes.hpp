#pragma once
/// Proposals that mend a scene file, as a script that `durero edit --script` carries out. Nothing is mended here.
///
/// A file that holds a scene gets operations: those that drop an element which is the same as another in all but its
/// name. A file that holds none, as an axis is no unit vector, gets a JSON Patch (file_patch.hpp): operations edit a
/// scene, and there is none.

#include <optional>
#include <string>

#include "durero/io/source.hpp"

namespace durero::io {

/// A proposal for a scene file.
struct SceneFixes {
  std::string script{};              ///< with a reason for each operation; empty where nothing is proposed
  std::optional<InputError> left{};  ///< the first thing wrong that the script does not mend
};

/// Proposes what may mend a scene file. Proposed are: an axis at unit length, in its own direction, rounded; an element
/// that stands twice dropped; a name that another element has changed; a triangle on one line dropped; a member of a
/// group dropped where it is no element or no group, or is in a group already. Each is a choice of the program, which
/// whoever made the scene may make otherwise. Time grows with the faults of groups times the file.
SceneFixes scene_fixes(const Source& file);

}  // namespace durero::io
