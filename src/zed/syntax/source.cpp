#include "zed/syntax/source.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

#include "durero/text/utf8.hpp"
#include "zed/syntax/characters.hpp"
#include "zed/syntax/lexer.hpp"

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

/// What Unicode mark-up would read as more than a word, or as none, could not be written there.
bool is_one_word(const std::string& meaning) {
  const Operators none;
  const std::vector<Token> tokens = lex_unicode(meaning, none);
  const Token& first = tokens.front();
  return tokens.size() == 2 && tokens.back().type == Token::Type::end && first.text == meaning &&
         first.strokes.empty() && (first.type == Token::Type::word || first.type == Token::Type::symbol);
}

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
  } else if (!is_one_word(meaning)) {
    throw ZError(place, "malformed word " + meaning, "expected one word of Z");
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

namespace {

constexpr std::array<std::string_view, 4> openers = {"─", "╷", "═", "┌"};

std::string_view opener(std::string_view line) {
  for (const std::string_view sign : openers)
    if (line.starts_with(sign)) return sign;
  return {};
}

/// Cuts a text in Unicode mark-up (ISO/IEC 13568, 8.2, and the boxes of to_unicode()): a paragraph begins with a line
/// that begins with ─ (what \begin{zed} is in LaTeX), ╷ or ┌ alone (axdef), ═ or ┌ [ (gendef) or ┌ NAME (schema), and
/// ends at a line that begins with └.
class UnicodeCutter {
 public:
  UnicodeCutter(std::string_view text, const std::string& file, std::vector<Defect>& defects)
      : cursor_{text}, file_(file), defects_(defects) {}

  std::vector<Block> run() {
    while (!cursor_.done()) {
      if (const std::string_view sign = opener(cursor_.rest_of_line()); !sign.empty()) {
        paragraph(sign);
      } else {
        next_line();
      }
    }
    return std::move(blocks_);
  }

 private:
  void next_line() { cursor_.skip(cursor_.rest_of_line().size() + 1); }

  static std::string environment(std::string_view sign, std::string_view title) {
    if (sign == "─") return title.starts_with("section") ? "zsection" : "zed";
    if (sign == "┌" && !title.empty()) return title[0] == '[' ? "gendef" : "schema";
    return sign == "═" || title.starts_with("[") ? "gendef" : "axdef";
  }

  void paragraph(std::string_view sign) {
    Block block;
    block.unicode = true;
    block.begin = cursor_.place;
    while (cursor_.sees("─") || cursor_.sees("═") || cursor_.sees("╷") || cursor_.sees("┌") || cursor_.sees(" "))
      cursor_.step();
    std::string_view title = cursor_.rest_of_line();
    if (title.empty() && sign == "─") title = cursor_.text.substr(std::min(cursor_.at + 1, cursor_.text.size()));
    title.remove_prefix(std::min(title.find_first_not_of(" \r"), title.size()));
    block.environment = environment(sign, title);
    block.place = cursor_.place;
    const std::size_t start = cursor_.at;
    next_line();
    while (!cursor_.done() && !cursor_.sees("└") && opener(cursor_.rest_of_line()).empty()) next_line();
    block.body = cursor_.text.substr(start, cursor_.at - start);
    block.end = cursor_.place;
    if (cursor_.sees("└")) {
      next_line();
      blocks_.push_back(std::move(block));
    } else {
      defects_.push_back({file_, block.begin, "the paragraph does not end", "expected a line that begins with └", {}});
    }
  }

  Cursor cursor_;
  const std::string& file_;
  std::vector<Defect>& defects_;
  std::vector<Block> blocks_;
};

/// Says whether a text is in Unicode mark-up: it has a box, and no environment of LaTeX.
bool is_unicode(std::string_view text) {
  if (text.find("\\begin{") != text.npos) return false;
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at), at += at == text.npos ? 0 : 1)
    if (!opener(text.substr(at)).empty()) return true;
  return false;
}

}  // namespace

std::vector<Block> cut(std::string_view text, const std::string& file, std::vector<Defect>& defects) {
  if (is_unicode(text)) return UnicodeCutter(text, file, defects).run();
  return Cutter(text, file, defects).run();
}

std::vector<Place> grouping_braces(const Block& block) {
  std::vector<Place> places;
  Cursor cursor{block.body, 0, block.place};
  bool belongs = block.environment == "schema";  // to its name, to _ or ^, or to a command
  while (!block.unicode && !cursor.done()) {
    const char c = cursor.text[cursor.at];
    if (c == '%') {
      cursor.skip(cursor.rest_of_line().size());
      continue;
    }
    if (c == '{' && !belongs) places.push_back(cursor.place);
    const bool escaped = c == '\\';
    if (escaped) cursor.step();
    const bool command = escaped && !cursor.done() && is_letter(cursor.text[cursor.at]);
    while (command && !cursor.done() && is_letter(cursor.text[cursor.at])) cursor.step();
    belongs = c == '_' || c == '^' || command || (belongs && is_space(c));
    if (!command && !cursor.done()) cursor.step();
  }
  return places;
}

}  // namespace durero::zed
