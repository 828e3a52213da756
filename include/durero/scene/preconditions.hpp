#pragma once
/// The preconditions of the edits that are no operations of spec/operaciones.tex, each judged, as model::pre() judges
/// those of an operation. A total edit answers the first that does not hold; these are all of them.

#include "durero/model/judgement.hpp"
#include "durero/scene/closing.hpp"
#include "durero/scene/copying.hpp"
#include "durero/scene/grouped_scene.hpp"
#include "durero/scene/joining.hpp"
#include "durero/scene/mesh_edit.hpp"

namespace durero::scene {

/// @{ The preconditions over the scene before, in the order of their labels. What is said of something that is not
/// there does not hold. Precondition: the names are names, and a solid has parts.
model::Judgements pre(const GroupedScene& before, const GroupEdit& in);
model::Judgements pre(const GroupedScene& before, const Copying& in);
model::Judgements pre(const GroupedScene& before, const CopyRemoval& in);
model::Judgements pre(const GroupedScene& before, const Joining& in);
model::Judgements pre(const GroupedScene& before, const SolidRemoval& in);
/// @}
/// Those of a closing; of its discs only where these hold, each as of the addition that it is.
model::Judgements pre(const GroupedScene& before, const Closing& in);
/// Those of spec/malla.tex. O(n).
model::Judgements pre(const GroupedScene& before, const MeshEdit& in);

}  // namespace durero::scene
