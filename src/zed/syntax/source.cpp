#include "zed/syntax/source.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

#include "durero/text/utf8.hpp"

namespace durero::zed {
namespace {

constexpr std::array<std::string_view, 5> environments = {"zsection", "zed", "axdef", "gendef", "schema"};

/// Walks over a text and knows its place.
struct Cursor {
  std::string_view text;
  std::size_t at = 0;
  Place place{1, 1};

  bool done() const { return at >= text.size(); }
  bool sees(std::string_view what) const { return text.substr(at, what.size()) == what; }
  void step() {
    if (text[at] == '\n') {
      ++place.line;
      place.column = 0;
    }
    ++at;
    while (!done() && text::continues(text[at])) ++at;
    ++place.column;
  }
  void skip(std::size_t bytes) {
    for (const std::size_t end = std::min(at + bytes, text.size()); at < end;) step();
  }
  std::string_view rest_of_line() const { return text.substr(at, text.find('\n', at) - at); }
};

/// Reads `%%Zchar \real U+211D`, `%%Zword \foo foo` and their kin for the spacing around (which the lexer does not
/// need).
void directive(std::string_view line, Place place, Markup& into) {
  std::istringstream words{std::string(line.substr(3))};
  std::string kind, command, meaning, more;
  words >> kind >> command >> meaning >> more;
  const bool is_char = kind == "char" || kind == "inchar" || kind == "prechar" || kind == "postchar";
  const bool is_word = kind == "word" || kind == "inword" || kind == "preword" || kind == "postword";
  if (!is_char && !is_word) throw ZError(place, "unknown directive %%Z" + kind, "expected %%Zchar or %%Zword");
  if (command.size() < 2 || command[0] != '\\' || meaning.empty() || !more.empty())
    throw ZError(place, "malformed directive", "expected a command, then its character or word");
  if (is_char) {
    unsigned code = 0;
    const std::string digits = meaning.substr(std::min<std::size_t>(2, meaning.size()));
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (!(meaning.starts_with("U+") || meaning.starts_with("U-")) || error != std::errc() ||
        end != digits.data() + digits.size() || !text::is_scalar(code) || code < 0x80)
      throw ZError(place, "malformed character " + meaning, "expected U+ and hexadecimal digits, beyond ASCII");
    meaning = text::encode(code);
  }
  into[command.substr(1)] = meaning;
}

class Cutter {
 public:
  Cutter(std::string_view text, const std::string& file, std::vector<Defect>& defects)
      : cursor_{text}, file_(file), defects_(defects) {}

  std::vector<Block> run() {
    while (!cursor_.done()) {
      if (cursor_.sees("%")) {
        comment();
      } else if (cursor_.sees("\\begin{")) {
        begin();
      } else if (cursor_.sees("\\")) {
        cursor_.skip(2);
      } else {
        cursor_.step();
      }
    }
    return std::move(blocks_);
  }

 private:
  void comment() {
    const std::string_view line = cursor_.rest_of_line();
    if (line.starts_with("%%Z") && cursor_.place.column == 1) {
      try {
        directive(line, cursor_.place, pending_);
      } catch (const ZError& error) {
        defects_.push_back(error.in(file_));
      }
    }
    cursor_.skip(line.size());
  }

  void begin() {
    Block block;
    block.begin = cursor_.place;
    cursor_.skip(7);
    const std::string_view rest = cursor_.rest_of_line();
    block.environment = rest.substr(0, rest.find('}'));
    if (std::find(environments.begin(), environments.end(), block.environment) == environments.end()) return;
    cursor_.skip(block.environment.size() + 1);
    block.place = cursor_.place;
    const std::size_t start = cursor_.at;
    const std::string closing = "\\end{" + block.environment + "}";
    while (!cursor_.done() && !cursor_.sees(closing) && !cursor_.sees("\\begin{")) inside(block);
    block.body = cursor_.text.substr(start, cursor_.at - start);
    block.end = cursor_.place;
    block.directives = std::move(pending_);
    pending_.clear();
    if (!cursor_.sees(closing)) {
      defects_.push_back({file_, block.begin, "the paragraph does not end", "expected " + closing, {}});
      return;
    }
    cursor_.skip(closing.size());
    blocks_.push_back(std::move(block));
  }

  void inside(const Block& block) {
    if (cursor_.sees("%%Z") && cursor_.place.column == 1)
      defects_.push_back({file_,
                          cursor_.place,
                          "a directive inside a paragraph",
                          "expected it before the \\begin{" + block.environment + "}",
                          {}});
    if (cursor_.sees("%")) {
      cursor_.skip(cursor_.rest_of_line().size());
    } else if (cursor_.sees("\\\\") || cursor_.sees("\\%")) {
      cursor_.skip(2);
    } else {
      cursor_.step();
    }
  }

  Cursor cursor_;
  const std::string& file_;
  std::vector<Defect>& defects_;
  std::vector<Block> blocks_;
  Markup pending_;
};

}  // namespace

std::vector<Block> cut(std::string_view text, const std::string& file, std::vector<Defect>& defects) {
  return Cutter(text, file, defects).run();
}

}  // namespace durero::zed
