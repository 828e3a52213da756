#include "zed/print/layout.hpp"

#include <algorithm>
#include <array>

#include "zed/syntax/characters.hpp"

namespace durero::zed {
namespace {

std::string_view comment_at(std::string_view text, std::size_t at) {
  std::string_view comment = text.substr(at, text.find('\n', at) - at);
  while (is_space(comment.back())) comment.remove_suffix(1);
  return comment;
}

/// Walks over what stands between two tokens of LaTeX.
class LatexLayout {
 public:
  explicit LatexLayout(std::string_view text) : text_(text) {}

  Layout run() {
    while (at_ < text_.size()) step();
    if (broken_) next_line();
    return std::move(lines_);
  }

 private:
  void step() {
    const char c = text_[at_];
    if (c == '\n') {
      ++at_;
      line_end();
    } else if (c == '%') {
      if (margin_ && lines_.size() == 1) next_line();  // it has a line of the source for itself
      lines_.back().comment = comment_at(text_, at_);
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (c == '\\') {
      command();
    } else {
      ++at_;
      if (c != '{' && c != '}' && c != '\r' && !margin_) ++lines_.back().blanks;
    }
  }

  /// A line end of the source ends a line of Z behind `\\` or a comment; else it is a blank, and so are those that the
  /// next line of the source begins with.
  void line_end() {
    if (broken_ || !lines_.back().comment.empty()) return next_line();
    if (lines_.back().blanks == 0) lines_.back().blanks = 1;
    margin_ = true;
  }

  void next_line() {
    lines_.emplace_back();
    broken_ = false;
    margin_ = true;
  }

  void command() {
    std::size_t end = at_ + 1;
    while (end < text_.size() && is_letter(text_[end])) ++end;
    const std::string_view name = text_.substr(at_ + 1, end - at_ - 1);
    at_ = std::max(end, at_ + 2);
    static constexpr std::array<std::string_view, 3> spaces = {"also", "znewpage", "zbreak"};
    if (name.empty() && text_[at_ - 1] == '\\') {
      if (broken_) next_line();
      lines_.back().blanks = 0;
      broken_ = true;
      margin_ = false;
    } else if (std::find(spaces.begin(), spaces.end(), name) != spaces.end()) {
      if (broken_ || lines_.size() == 1) next_line();
      next_line();
    } else if (name == "t") {
      if (broken_) next_line();
      std::size_t steps = 0;
      for (; at_ < text_.size() && is_digit(text_[at_]); ++at_)
        steps = std::min<std::size_t>(most_steps, 10 * steps + static_cast<std::size_t>(text_[at_] - '0'));
      lines_.back().indent += steps;
      margin_ = true;
    } else {
      ++lines_.back().blanks;
    }
  }

  static constexpr std::size_t most_steps = 99;
  std::string_view text_;
  std::size_t at_ = 0;
  Layout lines_ = Layout(1);
  bool broken_ = false;  // `\\` was read, and the line goes on to the end of the source's, for a comment
  bool margin_ = false;  // blanks count for nothing: a line of the source begins, or an indent stands there
};

}  // namespace

Layout layout_of_latex(std::string_view text) { return LatexLayout(text).run(); }

Layout layout_of_unicode(std::string_view text) {
  Layout lines(1);
  static constexpr std::string_view side = "│", rule = "─";
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (text.substr(at).starts_with(side) || text.substr(at).starts_with(rule)) {
      at += side.size();
      if (at < text.size() && text[at] == ' ' && lines.back().blanks == 0) ++at;  // it belongs to the box
      continue;
    }
    if (c == '%') {
      lines.back().comment = comment_at(text, at);
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (c == '\n') lines.emplace_back();
    if (c != '\n' && c != '\r') ++lines.back().blanks;
    ++at;
  }
  if (lines.size() > 1) lines.back().indent = lines.back().blanks / 2;
  return lines;
}

std::string in_latex(const Layout& layout, Break kind) {
  const auto is_space_between = [](const LayoutLine& line) { return line.comment.empty(); };
  const LayoutLine& first = layout.front();
  if (layout.size() == 1) return std::string(first.blanks, ' ');
  const bool spaced = std::any_of(layout.begin() + 1, layout.end() - 1, is_space_between);
  std::string text = kind == Break::marked && !spaced ? " \\\\" : "";
  if (!first.comment.empty()) text += std::string(first.blanks, ' ') + first.comment;
  text += '\n';
  for (std::size_t i = 1; i + 1 < layout.size(); ++i)
    text += (layout[i].comment.empty() ? "\\also" : "  " + layout[i].comment) + "\n";
  text += "  ";
  for (std::size_t steps = layout.back().indent; steps > 0; steps -= std::min<std::size_t>(steps, 9))
    text += "\\t" + std::to_string(std::min<std::size_t>(steps, 9)) + " ";
  return text;
}

std::string in_unicode(const Layout& layout) {
  const LayoutLine& first = layout.front();
  if (layout.size() == 1) return std::string(first.blanks, ' ');
  std::string text = first.comment.empty() ? "" : std::string(first.blanks, ' ') + first.comment;
  for (std::size_t i = 1; i < layout.size(); ++i) text += "\n" + layout[i].comment;
  return text + std::string(2 * layout.back().indent, ' ');
}

}  // namespace durero::zed
