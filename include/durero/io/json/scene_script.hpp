#pragma once
/// The script that makes one scene of another.

#include <string>
#include <vector>

#include "durero/io/json/operations_file.hpp"
#include "durero/scene/grouped_scene.hpp"

namespace durero::io {

/// A script that makes one scene of another, and the parts that it leaves.
struct SceneScript {
  std::vector<ScriptStep> steps;    ///< line after line
  std::vector<std::string> beyond;  ///< the parts that no operation makes as they are to be, by their pointers
};

/// The steps by which EditedScene makes `to` of `from`: the same bytes of scene_text(). A part that is the same in both
/// is in no step. An element that differs is changed, attribute by attribute, or it is removed and added where that is
/// shorter or no change makes it so. Groups are made anew by the fewest edits, or elements move between them, whichever
/// is shorter. Parts of bodies that are no elements are made, and removed behind the last. Materials are places in the
/// stage of both. There are no steps where something is beyond operations: a difference of the stages, or a new element
/// that moves, is mapped by fractions that are no binary64, or has normals or uv.
SceneScript script_between(const scene::GroupedScene& from, const scene::GroupedScene& to);

/// The script as text, a canonical line each. Precondition: the stage is that of both scenes.
std::string script_text(const SceneScript& script, const scene::Stage& stage);

}  // namespace durero::io
