#include "zed/syntax/source.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <sstream>
#include <utility>

#include "durero/text/utf8.hpp"
#include "zed/syntax/characters.hpp"
#include "zed/syntax/cursor.hpp"
#include "zed/syntax/lexer.hpp"
#include "zed/syntax/symbols.hpp"

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

/// Says whether a character of ASCII is a sign of Z.
bool is_sign(unsigned code) {
  const char sign = static_cast<char>(code);
  return !is_letter(sign) && !is_digit(sign) && is_one_word({sign});
}

/// Returns what a text of LaTeX mark-up means, by ISO Z and by the directives before it: its words, with a blank
/// between two but where one stands in braces, which take the blanks of a command from it (ISO/IEC 13568, A.2.3).
/// Nothing where it is none, or one has a stroke.
std::string meaning_of(const std::string& latex, const Markup& known) {
  static const Operators none;
  Block block;
  block.environment = "zed";
  block.body = latex;
  const std::vector<Token> tokens = lex_latex(block, known, none);
  std::string meaning;
  bool braced = true;
  for (const Token& token : tokens) {
    if (token.type == Token::Type::error || !token.strokes.empty()) return {};
    if (token.type == Token::Type::end) break;
    const bool inside = token.from > 0 && latex[token.from - 1] == '{';
    if (!braced && !inside) meaning += ' ';
    meaning += token.text;
    braced = inside;
  }
  return meaning;
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
        end != digits.data() + digits.size() || !text::is_scalar(code) || (code < 0x80 && !is_sign(code)))
      throw ZError(place, "malformed character " + meaning,
                   "expected U+ and hexadecimal digits, beyond ASCII or a sign of Z");
    meaning = text::encode(code);
  } else if (meaning.find_first_of("\\{") != meaning.npos) {
    const std::string latex = meaning;
    meaning = meaning_of(latex, into);
    if (meaning.empty()) throw ZError(place, "malformed word " + latex, "expected words of Z");
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
      : cursor_(text), file_(file), defects_(defects), spivey_(spivey_text(text)) {}

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
    if (cursor_.place().column == 1) {
      if (spivey_ && is_hidden_line(line)) return cursor_.skip(2);
      take_directive(cursor_, file_, pending_, defects_);
      if (spivey_ && line.starts_with("%%")) take_spivey_directive(line);
    }
    cursor_.skip(line.size());
  }

  void take_spivey_directive(std::string_view line) {
    try {
      auto directive = spivey_directive(line, cursor_.place());
      if (!directive) return;
      if (directive->kind == SpiveyDirective::Kind::unchecked) unchecked_ = cursor_.place();
      if (directive->kind == SpiveyDirective::Kind::ignored)
        for (const std::string& word : directive->words) pending_[word] = "";
      for (std::size_t i = 0; i < directive->operators.size(); ++i) {
        OperatorTemplate& read = directive->operators[i];
        const std::string& word = directive->words[i];
        std::string& text = read.parts[read.has_left() ? 1 : 0];
        if (const std::string* const own = own_meaning(word))
          text = *own;
        else if (!unicode_of_command(word))
          pending_[word] = text;
        pending_operators_.push_back(std::move(read));
      }
    } catch (const ZError& error) {
      defects_.push_back(error.in(file_));
    }
  }

  /// The text that a %%Z directive above gives a command, or null.
  const std::string* own_meaning(const std::string& command) const {
    for (const Markup* const directives : {&pending_, &taken_})
      if (const auto found = directives->find(command); found != directives->end()) return &found->second;
    return nullptr;
  }

  void begin() {
    Block block;
    block.begin = cursor_.place();
    const std::size_t whole = cursor_.at;
    cursor_.skip(7);
    const std::string_view rest = cursor_.rest_of_line();
    const std::string written(rest.substr(0, rest.find('}')));
    const std::size_t title = written == "theorem" ? title_of_conjecture(block.begin) : 0;
    const bool is_read = title > 0 || (written == "syntax" && spivey_) ||
                         std::find(environments.begin(), environments.end(), written) != environments.end();
    if (!is_read) return;
    block.environment = title > 0 || written == "syntax" ? "zed" : written;
    block.spivey = spivey_;
    began_ = true;
    cursor_.skip(written.size() + 1 + title);
    block.place = cursor_.place();
    const std::size_t start = cursor_.at;
    const std::string closing = "\\end{" + written + "}";
    while (!cursor_.done() && !cursor_.sees(closing) && !cursor_.sees("\\begin{")) inside(block);
    block.body = cursor_.text.substr(start, cursor_.at - start);
    block.end = cursor_.place();
    taken_.insert(pending_.begin(), pending_.end());
    block.directives = std::exchange(pending_, {});
    block.operators = std::exchange(pending_operators_, {});
    if (!cursor_.sees(closing)) {
      defects_.push_back({file_, block.begin, "the paragraph does not end", "expected " + closing, {}});
      return;
    }
    cursor_.skip(closing.size());
    block.whole = cursor_.text.substr(whole, cursor_.at - whole);
    if (const auto unchecked = std::exchange(unchecked_, std::nullopt))
      defects_.push_back({file_, *unchecked, "the paragraph behind this is not read", "expected no %%unchecked",
                          Defect::Severity::warning});
    else
      blocks_.push_back(std::move(block));
  }

  /// CZT and Z/EVES name a conjecture so: `\begin{theorem}{NAME} \vdash? …`. Returns how many bytes the title has with
  /// its braces; 0 of a theorem in prose, which says nothing in Z.
  std::size_t title_of_conjecture(Place place) {
    static constexpr std::string_view name = "theorem}", claim = "\\vdash?";
    const std::string_view rest = cursor_.text.substr(cursor_.at + name.size());
    const std::string_view inside = rest.substr(0, rest.find("\\end{theorem}"));
    const std::size_t claimed = inside.find(claim);
    if (claimed == inside.npos) return 0;
    const std::size_t open = inside.find_first_not_of(" \t\r\n"), close = inside.find('}');
    if (inside[open] == '{' && close < claimed) return close + 1;
    if (open == claimed || inside[open] == '[') return open;
    defects_.push_back({file_, place, "a theorem is not read, and its conjecture is not tried",
                        "expected \\begin{theorem}{NAME} \\vdash? … \\end{theorem}", Defect::Severity::warning});
    return 0;
  }

  void inside(const Block& block) {
    if (cursor_.sees("%%Z") && cursor_.place().column == 1)
      defects_.push_back({file_,
                          cursor_.place(),
                          "a directive inside a paragraph",
                          "expected it before the \\begin{" + block.environment + "}",
                          {}});
    if (spivey_ && cursor_.sees("%%") && cursor_.place().column == 1 && is_hidden_line(cursor_.rest_of_line())) {
      cursor_.skip(2);
    } else if (cursor_.sees("%")) {
      cursor_.skip(cursor_.rest_of_line().size());
    } else {
      skip();
    }
  }

  Cursor cursor_;
  const std::string& file_;
  std::vector<Defect>& defects_;
  std::vector<Block> blocks_;
  std::shared_ptr<const SpiveyText> spivey_;
  Markup pending_, taken_;  // of blocks to come, and of those before
  std::vector<OperatorTemplate> pending_operators_;
  std::optional<Place> unchecked_;  // fuzz leaves the next paragraph out
  bool began_ = false;
};

}  // namespace

bool is_unicode(std::string_view text) {
  if (!has_box(text)) return false;
  std::vector<Defect> defects;
  const std::string file;
  Cutter latex(text, file, defects);
  latex.run();
  return !latex.began();
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
