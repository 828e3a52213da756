#pragma once
/// Two changes of one scene, put together part by part (scene_parts.hpp).

#include <optional>
#include <string>
#include <vector>

#include "durero/contract/contract.hpp"
#include "durero/scene/grouped_scene.hpp"

namespace durero::io {

/// @{ The preconditions of a merge. The three scenes are functions from parts to values. A change of one side stands
/// if the other side has made none, or the same. Parts that stand may still make no scene together: what does not hold
/// then is a clause of scenes or groups, or, where no clause speaks of it, merge.pre.3.
inline constexpr contract::clause merge_pre_1{
    "merge.pre.1", "∀ p : dom ours ∩ dom theirs ⦁ ours p = theirs p ∨ p ↦ ours p ∈ base ∨ p ↦ theirs p ∈ base"};
inline constexpr contract::clause merge_pre_2{
    "merge.pre.2", "(dom base ∖ dom ours) ◁ theirs ⊆ base ∧ (dom base ∖ dom theirs) ◁ ours ⊆ base"};
inline constexpr contract::clause merge_pre_3{"merge.pre.3", "the parts that stand are those of a scene"};
/// @}

/// A part that keeps two changes from being put together.
struct MergeConflict {
  const contract::clause* violated;             ///< never null
  std::string part;                             ///< `/elementos/ball`; empty of the whole
  std::optional<std::string> message{};         ///< where the parts make no scene: what is wrong; what is expected
  std::optional<std::string> base{};            ///< the value before both changes; nothing where there was none
  std::optional<std::string> ours{}, theirs{};  ///< the value on each side; nothing where there is none
};

/// A merged scene, or the conflicts in its place.
struct SceneMerge {
  std::optional<scene::GroupedScene> scene;  ///< nothing where there is a conflict
  std::vector<MergeConflict> conflicts;      ///< in the order of the canonical text
};

/// Puts the changes from `base` to `ours` and to `theirs` together. It depends on the texts of the scenes alone, and
/// exchanging the sides exchanges them in the conflicts.
SceneMerge merged_scene(const scene::GroupedScene& base, const scene::GroupedScene& ours,
                        const scene::GroupedScene& theirs);

/// `{"part":"/elementos/ball","violated":"merge.pre.1","predicate":"…","base":{…},"ours":{…},"theirs":{…}}`, perhaps
/// with a message; without line end.
std::string conflict_text(const MergeConflict& conflict);

}  // namespace durero::io
