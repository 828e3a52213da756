#pragma once
/// An edited scene holds its groups too. Where a Z text defines the elements, each addition is checked against the text
/// as well: attributes outside the domain of puntos_TIPO are refused with the predicate that does not hold.

#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "durero/io/json/operations_file.hpp"
#include "durero/scene/grouped_scene.hpp"
#include "durero/written/engine.hpp"

namespace durero::written {

/// An edited scene. A copy shares the text.
class Edited {
 public:
  /// A scene of the program's own shapes, without a text.
  explicit Edited(scene::GroupedScene scene = {}) : of_(std::move(scene)) {}
  /// Reads a scene by the text. Throws io::InputError at the first thing that is wrong, in the scene or in the text.
  Edited(const io::Source& source, std::shared_ptr<const Text> text);

  /// The scene and its groups. Elements of types of the text stand in it as spheres, under their names.
  const scene::GroupedScene& of() const noexcept { return of_; }
  /// The text; null without one.
  const Text* text() const noexcept { return text_.get(); }
  /// The types that the text declares.
  std::span<const io::WrittenType> types() const;
  /// The element of that name, where it is of a type of the text; otherwise null.
  const io::WrittenElement* written(std::string_view name) const;

  /// @{ The total edits: where a predicate does not hold they change nothing, and answer so. They throw io::InputError
  /// where the text is wrong; the scene is then as it was.
  io::EditAnswer apply_total(const scene::Edit& edit);
  io::EditAnswer apply_total(const scene::GroupEdit& edit) { return io::edit_answer(of_.apply_total(edit)); }
  /// Adds all discs of a closing, or none: `closed`, or `closed_but_for_rounding` where they are not lids().exact.
  io::EditAnswer apply_total(const scene::Closing& in);
  io::EditAnswer apply_total(const io::WrittenEdit& edit);
  /// Applies a step; the answer tells of groups, too.
  io::EditAnswer apply_total(const io::ScriptStep& step);
  /// @}

  /// Applies an edit of the program's own shapes. Returns its answer with the clause that it breaks, and the answer of
  /// apply_total(Step). Precondition: there is no text.
  std::pair<model::Answer, io::EditAnswer> apply_own(const scene::Edit& edit);

  /// The engine that answers rays by the text. It does not refer to this scene. Precondition: there is a text.
  std::unique_ptr<const engine::Engine> engine() const;

  /// The stage of the scene, of which no text speaks.
  scene::Stage& stage() noexcept { return of_.scene.stage(); }

  /// The canonical text of its scene file.
  std::string scene_text() const;

 private:
  io::EditAnswer add(const io::WrittenAddition& in);
  io::EditAnswer remove(const io::WrittenRemoval& in);
  /// Carries out an addition, and then makes the surface. The addition is undone where the text does not give it one.
  template <class MakeSurface>
  io::EditAnswer add_if_given(const scene::Edit& edit, MakeSurface make);

  /// The group that the element is no more in after an edit, or none: it left `was_in`, or is back without its group.
  std::string left_group(const std::string& name, std::string was_in);

  scene::GroupedScene of_;
  std::shared_ptr<const Text> text_{};
  io::WrittenByName elements_{};
  std::map<std::string, std::string> left_{};  // the group of each removed element
};

}  // namespace durero::written
