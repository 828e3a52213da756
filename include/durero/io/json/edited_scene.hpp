#pragma once
/// A scene that operations edit, with its groups. The answers tell of a group that an element has left.

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "durero/io/json/operations_file.hpp"
#include "durero/scene/grouped_scene.hpp"
#include "durero/scene/stage.hpp"

namespace durero::io {

struct EditRecord;

/// An edited scene of the program's own shapes.
class EditedScene {
 public:
  explicit EditedScene(scene::GroupedScene scene = {}) : of_(std::move(scene)) {}  ///< begins with that scene
  virtual ~EditedScene() = default;

  /// The scene and its groups. Elements of types of a Z text stand in it as spheres, under their names.
  const scene::GroupedScene& of() const noexcept { return of_; }
  /// The types that a Z text declares: none, where there is no text.
  virtual std::span<const WrittenType> types() const { return {}; }

  /// @{ The total edits: where a predicate does not hold they change nothing, and answer so.
  /// A body is no sphere, though it stands as one: its removal as a sphere is refused.
  virtual EditAnswer apply_total(const scene::Edit& edit) { return edit_answer(own_answer(edit)); }
  EditAnswer apply_total(const scene::GroupEdit& edit) { return edit_answer(of_.apply_total(edit)); }
  /// Adds all discs of a closing, or none: `closed`, or `closed_but_for_rounding` where they are not lids().exact.
  EditAnswer apply_total(const scene::Closing& in);
  /// Adds an instance; beside a Z text there is none, and it throws std::domain_error.
  virtual EditAnswer apply_total(const scene::Copying& edit);
  EditAnswer apply_total(const scene::CopyRemoval& edit);
  /// Adds a solid; beside a Z text there is none, and it throws std::domain_error.
  virtual EditAnswer apply_total(const scene::Joining& edit);
  EditAnswer apply_total(const scene::SolidRemoval& edit);
  /// Edits a mesh; beside a Z text there is none, and it throws std::domain_error.
  virtual EditAnswer apply_total(scene::MeshEdit edit);
  /// Changes an attribute. An element of a type of a Z text, and a body, has none of them.
  virtual EditAnswer apply_total(const model::AttributeChange& change);
  /// Changes looks. Throws std::domain_error where a material with textures is for an element that has no coordinates
  /// (u, v): a body, or an element of a type of a Z text.
  EditAnswer apply_total(const model::LookChange& change);
  /// Precondition: there are types.
  virtual EditAnswer apply_total(const WrittenEdit& edit);
  /// Applies a step; the answer tells of groups, too.
  EditAnswer apply_total(const ScriptStep& step);
  /// @}

  /// @{ Applies an edit of the program's own shapes. Returns its answer with the clause that it breaks, and the answer
  /// of apply_total(ScriptStep). Precondition: there is no text.
  std::pair<model::Answer, EditAnswer> apply_own(const scene::Edit& edit);
  std::pair<model::Answer, EditAnswer> apply_own(const model::AttributeChange& change);
  std::pair<model::Answer, EditAnswer> apply_own(const model::LookChange& change);
  /// @}

  /// The element of a type of a Z text that has the name; nothing where none has.
  virtual std::optional<WrittenElement> written_record(const std::string&) const { return std::nullopt; }
  /// Puts back what an edit found (EditHistory).
  void restore(const EditRecord& record);

  /// A copy, which shares the text.
  virtual std::unique_ptr<EditedScene> copy() const { return std::unique_ptr<EditedScene>(new EditedScene(*this)); }

  /// The stage of the scene, of which no text speaks.
  scene::Stage& stage() noexcept { return of_.scene.stage(); }

  /// The canonical text of its scene file.
  virtual std::string scene_text() const;

 protected:
  EditedScene(const EditedScene&) = default;
  EditedScene(EditedScene&&) = default;
  EditedScene& operator=(const EditedScene&) = default;
  EditedScene& operator=(EditedScene&&) = default;

  /// Whether an element of the scene stands in it for one of a type of a Z text.
  virtual bool stands_in(const std::string&) const { return false; }

  /// Makes the element of that name one of a type of a Z text, or not one. Precondition: it stands in the scene so.
  virtual void set_written(const std::string&, std::optional<WrittenElement>) {}

  scene::GroupedScene of_;  ///< as edited so far

 private:
  void require_coordinates(const model::Cambiar_Material& in) const;
  model::Answer own_answer(const scene::Edit& edit);
  /// The group that the element is no more in after an edit, or none: it left `was_in`, or is back without its group.
  std::string left_group(const std::string& name, std::string was_in);

  std::map<std::string, std::string> left_{};  // the group of each removed element
};

/// The removal of the element of that name, whatever its type.
scene::Edit removal_of(const std::string& name);

}  // namespace durero::io
