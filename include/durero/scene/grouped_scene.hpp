#pragma once
/// A scene with the groups of its elements, as a scene file has both.

#include "durero/scene/groups.hpp"
#include "durero/scene/scene.hpp"

namespace durero::scene {

/// Both, which edits keep together.
struct GroupedScene {
  Scene scene = {};    ///< the elements
  Groups groups = {};  ///< of them

  /// @{ The total edits: where a precondition does not hold they change nothing, and answer so. An element that is
  /// removed leaves its group.
  model::Answer apply_total(const Edit& edit);
  model::Answer apply_total(MeshEdit edit);
  Outcome apply_total(const GroupEdit& edit) { return groups.apply_total(edit, scene); }
  /// @}
};

}  // namespace durero::scene
