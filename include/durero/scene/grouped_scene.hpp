#pragma once
/// A scene with the groups of its elements, as a scene file has both.

#include "durero/scene/groups.hpp"
#include "durero/scene/scene.hpp"

namespace durero::model {
struct Vista;
}  // namespace durero::model

namespace durero::scene {

/// Both, which edits keep together.
struct GroupedScene {
  Scene scene = {};    ///< the elements
  Groups groups = {};  ///< of them

  /// @{ The total edits: where a precondition does not hold they change nothing, and answer so. An element that is
  /// removed leaves its group; one that is changed stays in it.
  model::Answer apply_total(const Edit& edit);
  model::Answer apply_total(MeshEdit edit);
  model::Answer change_total(const model::AttributeChange& change);
  /// A face has the material of its mesh, and no own one: es_de_malla.
  model::Answer change_looks(const model::LookChange& change);
  Outcome apply_total(const GroupEdit& edit) { return groups.apply_total(edit, scene); }
  /// @}
};

/// What the scene and its groups stand for: the elements with their materials and groups. O(n log n).
model::Vista retrieve_looks(const GroupedScene& of);

}  // namespace durero::scene
