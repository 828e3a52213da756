#include <array>
#include <utility>

#include "zed/syntax/cursor.hpp"
#include "zed/syntax/lexer.hpp"

namespace durero::zed {
namespace {

constexpr std::array<std::string_view, 4> openers = {"─", "╷", "═", "┌"};

std::string_view opener(std::string_view line) {
  if (!line.starts_with(openers[0][0])) return {};  // all have this first byte, and few lines do
  for (const std::string_view sign : openers)
    if (line.starts_with(sign)) return sign;
  return {};
}

class UnicodeCutter {
 public:
  UnicodeCutter(std::string_view text, const std::string& file, std::vector<Defect>& defects)
      : cursor_(text), file_(file), defects_(defects) {}

  std::vector<Block> run() {
    while (!cursor_.done()) {
      if (const std::string_view sign = opener(cursor_.rest_of_line()); !sign.empty()) {
        paragraph(sign);
        if (next_in_line_ > 0)
          cursor_.skip(std::exchange(next_in_line_, 0));
        else
          next_line();
      } else {
        take_directive(cursor_, file_, pending_, defects_);
        next_line();
      }
    }
    return std::move(blocks_);
  }

 private:
  void next_line() { cursor_.skip(cursor_.rest_of_line().size() + 1); }

  static std::string environment(std::string_view sign, std::string_view title) {
    if (sign == "─") return "zed";
    if (sign == "┌" && !title.empty()) return title[0] == '[' ? "gendef" : "schema";
    return sign == "═" || title.starts_with("[") ? "gendef" : "axdef";
  }

  void paragraph(std::string_view sign) {
    Block block;
    block.unicode = true;
    block.begin = cursor_.place();
    const std::size_t whole = cursor_.at;
    Cursor sign_end = cursor_;
    while (cursor_.sees("─") || cursor_.sees("═") || cursor_.sees("╷") || cursor_.sees("┌") || cursor_.sees(" ")) {
      const bool blank = cursor_.sees(" ");
      cursor_.step();
      if (!blank) sign_end = cursor_;
    }
    if (cursor_.sees("%")) cursor_ = sign_end;  // the blanks before a comment are its own
    std::string_view title = cursor_.rest_of_line();
    title.remove_prefix(std::min(title.find_first_not_of(" \r"), title.size()));
    block.environment = environment(sign, title);
    block.place = cursor_.place();
    const std::size_t start = cursor_.at;
    while (!to_end_in_line()) {
      next_line();
      if (cursor_.done() || !opener(cursor_.rest_of_line()).empty()) break;
    }
    block.body = cursor_.text.substr(start, cursor_.at - start);
    if (block.environment == "zed" && is_header(block.body)) block.environment = "zsection";
    block.end = cursor_.place();
    block.directives = std::move(pending_);
    pending_.clear();
    if (cursor_.sees("└")) {
      pass_end();
      block.whole = cursor_.text.substr(whole, cursor_.at - whole);
      blocks_.push_back(std::move(block));
    } else {
      defects_.push_back({file_, block.begin, "the paragraph does not end", "expected └, the end of its box", {}});
    }
  }

  /// Goes on to the └ of this line, which is a sign of Z wherever it stands but in a comment; false where there is
  /// none.
  bool to_end_in_line() {
    const std::string_view line = cursor_.rest_of_line();
    const std::size_t end = line.find("└");
    if (end > line.find('%')) return false;
    if (end == line.npos) return false;
    cursor_.skip(end);
    return true;
  }

  /// Goes on behind └ and the rule of its box, and to the paragraph that begins in the same line, if one does.
  void pass_end() {
    cursor_.step();
    while (cursor_.sees("─")) cursor_.step();
    const std::string_view line = cursor_.rest_of_line();
    const std::size_t next = line.find_first_not_of(" \t\r");
    if (next != line.npos && !opener(line.substr(next)).empty()) next_in_line_ = next;
  }

  /// Says whether the first word of a body is `section`.
  static bool is_header(std::string_view body) {
    const Operators none;
    const std::vector<Token> tokens = lex_unicode(body, none);
    return tokens.front().is("section");
  }

  Cursor cursor_;
  const std::string& file_;
  std::vector<Defect>& defects_;
  std::vector<Block> blocks_;
  Markup pending_;
  std::size_t next_in_line_ = 0;  // so many bytes before a paragraph that begins behind the end of another
};

}  // namespace

bool has_box(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at), at += at == text.npos ? 0 : 1)
    if (!opener(text.substr(at)).empty()) return true;
  return false;
}

std::vector<Block> cut_unicode(std::string_view text, const std::string& file, std::vector<Defect>& defects) {
  return UnicodeCutter(text, file, defects).run();
}

}  // namespace durero::zed
