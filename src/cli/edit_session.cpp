#include "edit_session.hpp"

#include <utility>

namespace durero::cli {

EditSession::EditSession(std::unique_ptr<io::EditedScene> first, Editor editor)
    : first_(std::move(first)), now_(first_->copy()), editor_(std::move(editor)) {}

io::EditAnswer EditSession::carry_out(const io::ScriptStep& step, const std::string& text) {
  io::EditAnswer answer = editor_(*now_, step);
  if (!answer.ok()) return answer;
  if (saved_ && *saved_ > done_) saved_.reset();
  history_.erase(history_.begin() + static_cast<std::ptrdiff_t>(done_), history_.end());
  history_.push_back({step, text});
  ++done_;
  return answer;
}

std::optional<std::string> EditSession::undo() {
  if (done_ == 0) return std::nullopt;
  --done_;
  fold();
  return history_[done_].text;
}

std::optional<std::string> EditSession::redo() {
  if (done_ == history_.size()) return std::nullopt;
  editor_(*now_, history_[done_].step);
  return history_[done_++].text;
}

void EditSession::fold() {
  now_ = first_->copy();
  for (std::size_t i = 0; i < done_; ++i) now_->apply_total(history_[i].step);
}

}  // namespace durero::cli
