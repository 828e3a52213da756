#include "durero/zed/lexer.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

#include "durero/zed/symbols.hpp"
#include "utf8.hpp"

namespace durero::zed {
namespace {

using Type = Token::Type;

template <std::size_t N>
bool among(std::string_view what, const std::array<std::string_view, N>& set) {
  return std::find(set.begin(), set.end(), what) != set.end();
}

/// Symbols that are names by themselves.
constexpr std::array<std::string_view, 8> word_symbols = {"𝔸", "ℕ", "ℕ₁", "ℤ", "∅", "⋃", "⋂", "⁀/"};
/// Names of the toolkit that end in a subscript 1; there it is no stroke.
constexpr std::array<std::string_view, 5> indexed = {"ℙ", "𝔽", "ℕ", "∃", "seq"};
constexpr std::array<std::string_view, 6> closing = {")", "]", "}", "⟩", "⦊", "⟫"};
constexpr std::array<std::string_view, 5> opening = {"(", "[", "{", "⟨", "⦉"};
constexpr std::array<std::string_view, 11> leading = {"¬", "∀", "∃", "∃₁", "λ", "μ", "θ", "ℙ", "let", "if", "pre"};
constexpr std::array<std::string_view, 10> digits = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};

/// A word that is a name, and no keyword or operator.
bool bears_strokes(std::string_view word) {
  const char c = word[0];
  const bool letters = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  if (!letters && !among(word, word_symbols)) return false;
  return !is_reserved(word) && !find_operator(word, Fixity::infix) && !find_operator(word, Fixity::prefix);
}

/// In bytes. Each stroke may be a decoration of a schema, and is looked up as one: two are many.
constexpr std::size_t max_strokes = 30;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_stroke(char c) { return c == '\'' || c == '!' || c == '?'; }

/// Can a predicate, expression or declaration end with this token?
bool ends(const Token& token) {
  if (token.type == Type::numeral || token.type == Type::stroke) return true;
  if (token.type == Type::newline || token.type == Type::end) return false;
  if (find_operator(token.text, Fixity::postfix) || token.text == "⦈") return true;
  if (token.type == Type::symbol) return among(token.text, closing);
  if (!token.strokes.empty() || token.text == "true" || token.text == "false") return true;
  return !is_reserved(token.text) && !find_operator(token.text, Fixity::infix) &&
         !find_operator(token.text, Fixity::prefix);
}

/// Can one begin with it? An infix `-` is taken to go on with the line before.
bool begins(const Token& token) {
  if (token.type == Type::numeral) return true;
  if (token.type != Type::word && token.type != Type::symbol) return false;
  if (find_operator(token.text, Fixity::infix) && token.strokes.empty()) return false;
  if (among(token.text, opening) || among(token.text, leading) || token.text == "⊢?") return true;
  if (find_operator(token.text, Fixity::prefix)) return true;
  return token.type == Type::word && token.text != "then" && token.text != "else";
}

/// `SCHEMA.KIND.NUMBER` and nothing else, but spaces around; or nothing.
std::string label_in(std::string_view comment) {
  const auto is_blank = [](char c) { return is_space(c) || c == '%'; };
  while (!comment.empty() && is_blank(comment.front())) comment.remove_prefix(1);
  while (!comment.empty() && is_space(comment.back())) comment.remove_suffix(1);
  const std::size_t first = comment.find('.'), second = comment.rfind('.');
  if (first == 0 || first == comment.npos || first == second) return {};
  const std::string_view schema = comment.substr(0, first), number = comment.substr(second + 1);
  static constexpr std::array<std::string_view, 5> kinds = {"pre", "post", "inv", "def", "axiom"};
  if (!among(comment.substr(first + 1, second - first - 1), kinds) || number.empty()) return {};
  const bool named =
      std::all_of(schema.begin(), schema.end(), [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
  return named && std::all_of(number.begin(), number.end(), is_digit) ? std::string(comment) : std::string();
}

/// What the two mark-ups share: a walk that knows its place, and tokens with the newlines that count.
class Lexer {
 protected:
  Lexer(std::string_view text, Place place) : text_(text), place_(place) {}

  bool done() const { return at_ >= text_.size(); }
  char here(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool sees(std::string_view what) const { return text_.substr(at_, what.size()) == what; }

  /// Takes one character, and returns it.
  std::string_view take() {
    const std::string_view one = utf8::first(text_.substr(at_));
    at_ += one.size();
    ++place_.column;
    if (one == "\n") place_ = {place_.line + 1, 1};
    return one;
  }
  std::string_view take(std::size_t bytes) {
    const std::size_t start = at_;
    while (at_ < start + bytes) take();
    return text_.substr(start, bytes);
  }

  void spaces() {
    while (!done() && is_space(here())) take();
  }

  void emit(Type type, std::string text, Place place, std::string strokes = {}) {
    if (strokes.size() > max_strokes) refuse(place, "a name with too many strokes", "expected a few");
    Token token{type, std::move(text), std::move(strokes), place, {}, false};
    if (newline_ && !tokens_.empty() && ends(tokens_.back()) && begins(token))
      tokens_.push_back({Type::newline, "\n", {}, *newline_, {}, false});
    newline_.reset();
    tokens_.push_back(std::move(token));
    behind_ = place_;
  }

  /// A word or symbol by its Unicode text.
  void emit(std::string_view text, Place place) {
    const bool word = among(text, word_symbols) || is_reserved(text) || is_letter(text[0]) || is_letter_symbol(text);
    emit(word ? Type::word : Type::symbol, std::string(text), place);
  }

  void newline(Place place) {
    if (!newline_) newline_ = place;
  }

  void numeral() {
    const Place place = place_;
    std::string number;
    while (is_digit(here())) number += take();
    emit(Type::numeral, std::move(number), place);
  }

  /// True where a digit below the line belongs to the name before it, and not to its strokes.
  static bool is_indexed(std::string_view word, std::string_view digit) { return digit == "₁" && among(word, indexed); }

  /// `::=`, `==` or one ASCII character; none where it means nothing in Z.
  std::string_view ascii_symbol() const {
    for (const std::string_view longer : {"::=", "=="})
      if (sees(longer)) return longer;
    static constexpr std::string_view singles = ":;,.()[]|=<>+-*/&";
    return singles.find(here()) != singles.npos && here() != '\0' ? text_.substr(at_, 1) : std::string_view();
  }

  [[noreturn]] void refuse(Place place, const std::string& what, const std::string& expected) const {
    throw ZError(place, what, expected);
  }

  void comment() {
    const std::string_view line = text_.substr(at_, text_.find('\n', at_) - at_);
    const std::string label = label_in(line);
    if (!label.empty() && !tokens_.empty() && tokens_.back().place.line == place_.line) tokens_.back().label = label;
    take(line.size());
  }

  /// True where what was read last can be the left operand of an infix operator.
  bool continues() const { return !tokens_.empty() && ends(tokens_.back()); }

  void unreadable(const ZError& error) {
    tokens_.push_back({Type::error, error.what_is_wrong, {}, error.place, error.expected, false});
  }

  std::vector<Token> finish() {
    tokens_.push_back({Type::end, {}, {}, behind_, {}, false});
    return std::move(tokens_);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  Place place_, behind_ = place_;  // behind the last token
  std::vector<Token> tokens_;
  std::optional<Place> newline_;
};

class Latex : Lexer {
 public:
  Latex(const Block& block, const Markup& markup) : Lexer(block.body, block.place), markup_(markup) {
    spaces();
    named_ = block.environment != "schema" || here() == '{';
  }

  std::vector<Token> run() {
    try {
      if (!named_) refuse(place_, "a schema without a name", "expected {NAME}");
      while (!done()) one();
    } catch (const ZError& error) {
      unreadable(error);
      return std::move(tokens_);
    }
    return finish();
  }

 private:
  void one() {
    const char c = here();
    if (is_space(c) || c == '~' || c == '{' || c == '}') {  // braces only group, in TeX
      take();
    } else if (c == '%') {
      comment();
    } else if (is_letter(c)) {
      word({}, place_);
    } else if (is_digit(c)) {
      numeral();
    } else if (is_stroke(c) || c == '_') {
      const Place place = place_;
      emit(Type::stroke, stroke(), place);
    } else if (c == '\\') {
      command();
    } else {
      plain();
    }
  }

  void plain() {
    const Place place = place_;
    if (here() == '@') {
      take();
      return emit("•", place);
    }
    const std::string_view symbol = ascii_symbol();
    if (symbol.empty()) {
      refuse(place, "the character " + std::string(utf8::first(text_.substr(at_))) + " means nothing here",
             "expected LaTeX mark-up of Z");
    }
    emit(Type::symbol, std::string(take(symbol.size())), place);
    tokens_.back().only_infix = symbol == "-";
  }

  /// One stroke, of which the first character is here.
  std::string stroke() {
    const Place place = place_;
    if (is_stroke(here())) return std::string(take());
    take();  // _
    const bool braced = here() == '{';
    if (braced) take();
    if (!is_digit(here())) refuse(place, "this subscript is not read", "expected one digit after _");
    const std::string_view digit = digits[static_cast<std::size_t>(here() - '0')];
    take();
    if (is_digit(here()) || (braced && here() != '}'))
      refuse(place, "this subscript is not read", "expected one digit after _");
    if (braced) take();
    return std::string(digit);
  }

  std::string strokes(std::string& word) {
    std::string found;
    while (is_stroke(here()) || here() == '_') {
      const std::string one = stroke();
      if (found.empty() && is_indexed(word, one)) {
        word += one;
      } else {
        found += one;
      }
    }
    return found;
  }

  /// The letters of a word, `begun` with those already taken.
  void word(std::string begun, Place place) {
    for (;;) {
      if (is_letter(here()) || (is_digit(here()) && !begun.empty())) {
        begun += take();
      } else if (sees("\\_")) {
        take(2);
        begun += '_';
      } else if (const auto letter = letter_command()) {
        begun += *letter;
      } else {
        break;
      }
    }
    std::string found = strokes(begun);
    emit(Type::word, std::move(begun), place, std::move(found));
  }

  std::string_view command_name() const {
    if (here() != '\\') return {};
    std::size_t length = 1;
    while (is_letter(here(length))) ++length;
    if (length == 1) length = 1 + utf8::first(text_.substr(std::min(at_ + 1, text_.size()))).size();
    const std::string_view name = text_.substr(at_ + 1, length - 1);
    return name == "vdash" && here(length) == '?' ? text_.substr(at_ + 1, length) : name;
  }

  /// Takes a command for a letter that joins with others, and the spaces that TeX drops behind it.
  std::optional<std::string> letter_command() {
    const std::string_view name = command_name();
    std::string letter;
    if (const auto own = markup_.find(name); own != markup_.end()) {
      if (static_cast<unsigned char>(own->second[0]) < 0x80 || utf8::first(own->second) != own->second) return {};
      letter = own->second;
    } else if (const auto known = unicode_of_command(name); known && is_letter_symbol(*known)) {
      letter = *known;
    } else {
      return {};
    }
    take(1 + name.size());
    spaces();
    return letter;
  }

  void command() {
    const Place place = place_;
    if (auto letter = letter_command()) return word(std::move(*letter), place);
    const std::string_view name = command_name();
    take(1 + name.size());
    static constexpr std::array<std::string_view, 7> blanks = {",", ";", ":", "!", " ", "quad", "qquad"};
    static constexpr std::array<std::string_view, 4> breaks = {"\\", "also", "znewpage", "zbreak"};
    if (among(name, blanks) || name == "\n") {
    } else if (among(name, breaks)) {
      newline(place);
    } else if (name == "t" && is_digit(here())) {
      while (is_digit(here())) take();
    } else if (name == "where") {
      emit("|", place);
    } else if (name == "&") {
      emit("&", place);
    } else {
      known(name, place);
    }
  }

  void known(std::string_view name, Place place) {
    const auto own = markup_.find(name);
    const auto found = own != markup_.end() ? std::optional<std::string_view>(own->second) : unicode_of_command(name);
    if (!found)
      refuse(place, "unknown command \\" + std::string(name), "expected a command of ISO Z or of a %%Z directive");
    if (name == "negate" && continues()) {
      if (!newline_) refuse(place, "\\negate takes no left operand", "expected - for the difference");
      tokens_.push_back({Type::newline, "\n", {}, *newline_, {}, false});
    }
    std::string text(*found);
    if (here() == '_' || (is_stroke(here()) && bears_strokes(text))) {
      std::string after = strokes(text);
      if (!after.empty()) return emit(Type::word, std::move(text), place, std::move(after));
    }
    emit(text, place);
  }

  const Markup& markup_;
  bool named_ = true;
};

class Unicode : Lexer {
 public:
  explicit Unicode(std::string_view text) : Lexer(text, {1, 1}) {}

  std::vector<Token> run() {
    try {
      while (!done()) one();
    } catch (const ZError& error) {
      unreadable(error);
      return std::move(tokens_);
    }
    return finish();
  }

 private:
  void one() {
    const char c = here();
    if (is_space(c)) {
      if (c == '\n') newline(place_);
      take();
    } else if (c == '%') {
      comment();
    } else if (is_digit(c)) {
      numeral();
    } else if (is_stroke(c) || stroke_here()) {
      const Place place = place_;
      emit(Type::stroke, stroke(), place);
    } else if (is_letter(c) || is_word_character()) {
      word();
    } else {
      symbol();
    }
  }

  std::string_view character() const { return utf8::first(text_.substr(std::min(at_, text_.size()))); }

  bool stroke_here() const {
    const std::string_view c = character();
    return c == "′" || among(c, digits);
  }

  std::string stroke() { return character() == "′" ? (take(), "'") : std::string(take()); }

  /// A letter of no symbol: outside ASCII, whatever this reader does not know as a symbol.
  bool is_word_character() const {
    const std::string_view c = character();
    if (c.empty() || static_cast<unsigned char>(c[0]) < 0x80 || stroke_here()) return false;
    static constexpr std::array<std::string_view, 10> others = {"•", "⦁", "−", "⊢", "λ", "μ", "θ", "…", "⁀", "‥"};
    if (among(c, others)) return c == "λ" || c == "μ" || c == "θ";
    if (among(c, word_symbols)) return false;
    return is_letter_symbol(c) || !latex_of(c);
  }

  void word() {
    const Place place = place_;
    std::string letters;
    while (is_letter(here()) || is_digit(here()) || here() == '_' || is_word_character()) letters += take();
    emit_with_strokes(std::move(letters), place);
  }

  void emit_with_strokes(std::string text, Place place) {
    std::string found;
    while (is_stroke(here()) || stroke_here()) {
      const std::string one = stroke();
      if (found.empty() && is_indexed(text, one)) {
        text += one;
      } else {
        found += one;
      }
    }
    if (!found.empty()) return emit(Type::word, std::move(text), place, std::move(found));
    if (is_letter(text[0]) || !latex_of(text)) return emit(Type::word, std::move(text), place);
    emit(text, place);
  }

  void symbol() {
    const Place place = place_;
    static constexpr std::string_view read_as[][2] = {{"⊢?", "⊢?"}, {"⁀/", "⁀/"}, {"..", "‥"}, {"⦁", "•"}, {"•", "•"},
                                                      {"@", "•"},   {"−", "-"},   {"\\", "∖"}, {"{", "{"}, {"}", "}"},
                                                      {"#", "#"},   {"_", "_"},   {"∗", "∗"}};
    for (const auto& [seen, meant] : read_as) {
      if (!sees(seen)) continue;
      take(seen.size());
      return emit(meant, place);
    }
    if (const std::string_view ascii = ascii_symbol(); !ascii.empty())
      return emit(Type::symbol, std::string(take(ascii.size())), place);
    if (!latex_of(character()) || static_cast<unsigned char>(here()) < 0x80)
      refuse(place, "the character " + std::string(character()) + " means nothing here", "expected Z in Unicode");
    std::string text(take());
    if (among(text, indexed) || among(text, word_symbols)) return emit_with_strokes(std::move(text), place);
    emit(text, place);
  }
};

}  // namespace

std::vector<Token> lex_latex(const Block& block, const Markup& markup) { return Latex(block, markup).run(); }

std::vector<Token> lex_unicode(std::string_view text) { return Unicode(text).run(); }

}  // namespace durero::zed
