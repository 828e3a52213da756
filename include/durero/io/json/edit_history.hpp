#pragma once
/// The edits of a scene in their order, with what undoes each (spec/historia.tex): transactions, undo and redo. It is a
/// refinement of model::Historia, whose fold it never makes: it keeps what a step found, and puts it back.

#include <cstddef>
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "durero/io/json/edited_scene.hpp"
#include "durero/io/json/operations_file.hpp"
#include "durero/scene/element_record.hpp"

namespace durero::io {

/// The state of a scene before one edit, where the edit changes it.
struct EditRecord {
  std::vector<scene::ElementRecord> elements{};                                  ///< of each element that it concerns
  std::vector<std::pair<std::string, std::optional<WrittenElement>>> written{};  ///< of these, what a Z text declares
  std::optional<scene::MeshRecord> mesh{};                                       ///< of the mesh that it concerns
  std::optional<scene::Groups> groups{};                                         ///< of an edit of groups, all of them
};

/// A step of a history: edits that were done one after the other, and undone together.
struct HistoryStep {
  std::vector<ScriptStep> edits{};    ///< what was done, in order
  std::vector<EditRecord> records{};  ///< in step with these: what each found
};

/// The history of one scene. A value: with a copy of the scene it may be copied. Precondition of the members that take
/// a scene: it is the one that all edits of this history were done on, and no other edit was.
class EditHistory {
 public:
  /// Of any number of steps.
  EditHistory() = default;
  /// Of so many steps: where another is done, the first is forgotten, and can be undone no more.
  explicit EditHistory(std::size_t most) : most_(most) {}

  /// Applies an edit. One that is done is a step, or where a transaction is open a part of it; steps that were undone
  /// are forgotten then. One that is refused leaves history and scene as they are. Throws what the scene throws.
  EditAnswer apply_total(EditedScene& scene, const ScriptStep& edit);
  /// A function that carries an edit out, as one that asks the text, too.
  using CarryOutEdit = std::function<EditAnswer(EditedScene& scene, const ScriptStep& edit)>;
  /// Applies an edit as apply_total() does, by another function.
  EditAnswer apply_by(EditedScene& scene, const ScriptStep& edit, const CarryOutEdit& carry_out);

  /// Opens a transaction (Transaccion): the edits until its end are one step. Precondition: none is open.
  void begin();
  /// @{ Ends it: as one step, or with everything undone. Precondition: one is open.
  void commit();
  void roll_back(EditedScene& scene);
  /// @}
  /// Whether a transaction is open.
  bool is_open() const noexcept { return open_.has_value(); }
  /// Applies edits, all or none: a step, or where a transaction is open a part of it. Answers of all, or of those to
  /// the first that is refused; then nothing is done. Throws what the scene throws, and then nothing is done either.
  std::vector<EditAnswer> apply_all(EditedScene& scene, std::span<const ScriptStep> edits);

  /// @{ Undoes the last step, or does the one again that was undone last (Deshacer, Rehacer). False, and nothing
  /// changes, where there is none: Nada_Que_Deshacer.pre.1, Nada_Que_Rehacer.pre.1. Precondition: no transaction is
  /// open.
  bool undo(EditedScene& scene);
  bool redo(EditedScene& scene);
  /// @}

  /// @{ The steps that are done, in order, and those that were undone, the next to be done again last.
  const std::deque<HistoryStep>& done() const noexcept { return done_; }
  const std::deque<HistoryStep>& undone() const noexcept { return undone_; }
  /// @}
  /// Forgets all steps. Precondition: no transaction is open.
  void clear();

 private:
  /// Keeps a step that was done.
  void keep(HistoryStep step);
  /// Undoes the edits of the open transaction behind the first so many.
  void roll_back_to(EditedScene& scene, std::size_t edits);

  std::size_t most_ = std::numeric_limits<std::size_t>::max();
  std::deque<HistoryStep> done_{}, undone_{};
  std::optional<HistoryStep> open_{};
};

}  // namespace durero::io
