#include "zed/syntax/source.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

#include "durero/text/utf8.hpp"
#include "zed/syntax/characters.hpp"
#include "zed/syntax/cursor.hpp"
#include "zed/syntax/lexer.hpp"

namespace durero::zed {
namespace {

constexpr std::array<std::string_view, 5> environments = {"zsection", "zed", "axdef", "gendef", "schema"};

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

}  // namespace

void take_directive(Cursor& at, const std::string& file, Markup& into, std::vector<Defect>& defects) {
  const std::string_view line = at.rest_of_line();
  if (!line.starts_with("%%Z")) return;
  try {
    directive(line, at.place(), into);
  } catch (const ZError& error) {
    defects.push_back(error.in(file));
  }
}

namespace {

class Cutter {
 public:
  Cutter(std::string_view text, const std::string& file, std::vector<Defect>& defects)
      : cursor_(text), file_(file), defects_(defects) {}

  /// Says whether a paragraph began, be it that it did not end.
  bool began() const { return began_; }

  std::vector<Block> run() {
    while (!cursor_.done()) {
      if (cursor_.sees("%")) {
        comment();
      } else if (cursor_.sees("\\begin{")) {
        begin();
      } else {
        skip();
      }
    }
    return std::move(blocks_);
  }

 private:
  /// Goes on to where a command or a comment may begin: what stands behind a backslash begins none.
  void skip() {
    if (cursor_.sees("\\")) cursor_.skip(2);
    cursor_.skip_to([](char c) { return c == '\\' || c == '%'; });
  }

  void comment() {
    const std::string_view line = cursor_.rest_of_line();
    if (cursor_.place().column == 1) take_directive(cursor_, file_, pending_, defects_);
    cursor_.skip(line.size());
  }

  void begin() {
    Block block;
    block.begin = cursor_.place();
    cursor_.skip(7);
    const std::string_view rest = cursor_.rest_of_line();
    block.environment = rest.substr(0, rest.find('}'));
    if (block.environment == "theorem") warn_of_theorem(block.begin);
    if (std::find(environments.begin(), environments.end(), block.environment) == environments.end()) return;
    began_ = true;
    cursor_.skip(block.environment.size() + 1);
    block.place = cursor_.place();
    const std::size_t start = cursor_.at;
    const std::string closing = "\\end{" + block.environment + "}";
    while (!cursor_.done() && !cursor_.sees(closing) && !cursor_.sees("\\begin{")) inside(block);
    block.body = cursor_.text.substr(start, cursor_.at - start);
    block.end = cursor_.place();
    block.directives = std::move(pending_);
    pending_.clear();
    if (!cursor_.sees(closing)) {
      defects_.push_back({file_, block.begin, "the paragraph does not end", "expected " + closing, {}});
      return;
    }
    cursor_.skip(closing.size());
    blocks_.push_back(std::move(block));
  }

  /// CZT and Z/EVES name a conjecture so; prose has theorems too, which say nothing in Z.
  void warn_of_theorem(Place place) {
    const std::string_view rest = cursor_.text.substr(cursor_.at);
    if (rest.substr(0, rest.find("\\end{theorem}")).find("\\vdash?") == rest.npos) return;
    defects_.push_back({file_, place, "a theorem is not read, and its conjecture is not tried",
                        "expected \\begin{zed} \\vdash? … \\end{zed}", Defect::Severity::warning});
  }

  void inside(const Block& block) {
    if (cursor_.sees("%%Z") && cursor_.place().column == 1)
      defects_.push_back({file_,
                          cursor_.place(),
                          "a directive inside a paragraph",
                          "expected it before the \\begin{" + block.environment + "}",
                          {}});
    if (cursor_.sees("%")) {
      cursor_.skip(cursor_.rest_of_line().size());
    } else {
      skip();
    }
  }

  Cursor cursor_;
  const std::string& file_;
  std::vector<Defect>& defects_;
  std::vector<Block> blocks_;
  Markup pending_;
  bool began_ = false;
};

}  // namespace

bool is_unicode(std::string_view text) {
  std::vector<Defect> defects;
  const std::string file;
  Cutter latex(text, file, defects);
  return has_box(text) && (latex.run(), !latex.began());
}

std::vector<Block> cut(std::string_view text, const std::string& file, std::vector<Defect>& defects) {
  if (is_unicode(text)) return cut_unicode(text, file, defects);
  return Cutter(text, file, defects).run();
}

std::vector<Place> grouping_braces(const Block& block) {
  std::vector<Place> places;
  Cursor cursor(block.body, block.place);
  bool belongs = block.environment == "schema";  // to its name, to _ or ^, or to a command
  while (!block.unicode) {
    if (!belongs) cursor.skip_to([](char c) { return c == '%' || c == '{' || c == '\\' || c == '_' || c == '^'; });
    if (cursor.done()) break;
    const char c = cursor.text[cursor.at];
    if (c == '%') {
      cursor.skip(cursor.rest_of_line().size());
      continue;
    }
    if (c == '{' && !belongs) places.push_back(cursor.place());
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
