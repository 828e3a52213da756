#include "edit_session.hpp"

#include <utility>

namespace durero::cli {

EditSession::EditSession(std::unique_ptr<io::EditedScene> first, Editor editor)
    : scene_(std::move(first)), editor_(std::move(editor)) {}

io::EditAnswer EditSession::carry_out(const io::ScriptStep& step, const std::string& text) {
  io::EditAnswer answer = history_.apply_by(*scene_, step, editor_);
  if (!answer.ok()) return answer;
  if (saved_ && *saved_ >= done()) saved_.reset();
  texts_.resize(done() - 1);
  texts_.push_back(text);
  return answer;
}

std::optional<std::string> EditSession::undo() {
  if (!history_.undo(*scene_)) return std::nullopt;
  return texts_[done()];
}

std::optional<std::string> EditSession::redo() {
  if (!history_.redo(*scene_)) return std::nullopt;
  return texts_[done() - 1];
}

}  // namespace durero::cli
