#pragma once
/// A session edits one scene, operation by operation, and can take each of them back.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "by_text.hpp"
#include "durero/io/json/edit_history.hpp"
#include "durero/io/json/edited_scene.hpp"
#include "durero/io/json/operations_file.hpp"

namespace durero::cli {

/// A scene with the operations that were carried out on it.
class EditSession {
 public:
  /// Begins with a scene, which is as it was saved.
  EditSession(std::unique_ptr<io::EditedScene> first, Editor editor);

  /// The scene as it stands.
  const io::EditedScene& scene() const noexcept { return *scene_; }
  /// Carries out an operation, which was typed as this text. Where it is done, what was taken back before cannot be
  /// done again.
  io::EditAnswer carry_out(const io::ScriptStep& step, const std::string& text);
  /// @{ Takes the last operation back, or does it again: its text; nothing where there is none.
  std::optional<std::string> undo();
  std::optional<std::string> redo();
  /// @}

  /// @{ The state as it stands is, or is noted to be, the one that was saved.
  bool is_saved() const noexcept { return saved_ == done(); }
  void note_saved() noexcept { saved_ = done(); }
  /// @}
  /// How many operations are carried out and not taken back.
  std::size_t done() const noexcept { return history_.done().size(); }

 private:
  std::unique_ptr<io::EditedScene> scene_;
  Editor editor_;
  io::EditHistory history_{};
  std::vector<std::string> texts_{};      // of the operations that are done, and of those that were taken back
  std::optional<std::size_t> saved_ = 0;  // nothing: no state that can be reached again
};

}  // namespace durero::cli
