#pragma once
/// The lexers of the two mark-ups share what is here.

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "durero/text/utf8.hpp"
#include "zed/syntax/characters.hpp"
#include "zed/syntax/lexer.hpp"
#include "zed/syntax/symbols.hpp"

namespace durero::zed::lexing {

using Type = Token::Type;

template <std::size_t N>
bool among(std::string_view what, const std::array<std::string_view, N>& set) {
  return std::find(set.begin(), set.end(), what) != set.end();
}

inline constexpr std::array<std::string_view, 6> closing = {")", "]", "}", "⟩", "⦊", "⟫"};
inline constexpr std::array<std::string_view, 5> opening = {"(", "[", "{", "⟨", "⦉"};
inline constexpr std::array<std::string_view, 10> digits = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};

/// Says whether a word is a name, and no keyword or operator, so that strokes behind it are its own.
bool bears_strokes(std::string_view word);

/// A name has no more bytes of strokes than these. Each stroke may be a decoration of a schema, and is looked up as
/// one: two are many.
inline constexpr std::size_t max_strokes = 30;

/// Says whether a character beyond ASCII is taken for a letter, where it is no symbol that this reader knows: arrows,
/// operators and the signs of punctuation (U+2000 to U+206F, U+2190 to U+2BFF) are none.
bool is_other_letter(std::string_view character);

/// Says whether a predicate, expression or declaration can end with this token.
bool ends(const Token& token);

/// Says whether one can begin with it. An infix `-` is taken to go on with the line before.
bool begins(const Token& token);

/// Returns the label of a comment that is `SCHEMA.KIND.NUMBER` and nothing else, but for spaces around; or nothing.
std::string label_in(std::string_view comment);

/// A lexer walks over a text and knows its place, and keeps the tokens with the newlines that count.
class Lexer {
 protected:
  Lexer(std::string_view text, Place place, const Operators& operators)
      : text_(text), place_(place), operators_(operators) {}

  bool done() const { return at_ >= text_.size(); }
  char here(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool sees(std::string_view what) const { return here() == what.front() && text_.substr(at_, what.size()) == what; }

  /// Takes one character, and returns it.
  std::string_view take() {
    if (here() == '\n') place_ = {place_.line + 1, 0};
    const bool is_ascii = static_cast<unsigned char>(here()) < 0x80;
    const std::string_view character = is_ascii ? text_.substr(at_, 1) : text::first(text_.substr(at_));
    at_ += character.size();
    ++place_.column;
    return character;
  }
  std::string_view take(std::size_t bytes) {
    const std::size_t start = at_;
    while (at_ < start + bytes) take();
    return text_.substr(start, bytes);
  }

  void spaces() {
    while (is_space(here())) take();
  }

  /// Takes the letters and digits here.
  std::string_view letters() {
    const std::size_t start = at_;
    while (is_letter(here()) || is_digit(here())) take();
    return text_.substr(start, at_ - start);
  }

  void emit(Type type, Word text, Place place, Word strokes = {}) {
    if (strokes.size() > max_strokes) refuse(place, "a name with too many strokes", "expected a few");
    Token& token = tokens_.emplace_back();
    token.type = type;
    token.text = text;
    token.strokes = strokes;
    token.place = place;
    token.from = static_cast<std::uint32_t>(start_);
    if (token.strokes.empty() && (type == Type::word || type == Type::symbol)) {
      token.own = own(token.text);
      if (!token.own) token.symbol = &token.text.symbol();
    }
    ends_here();
    if (newline_) separate();
  }

  /// Puts the line break that was seen before the last token, where it separates that from the one before.
  void separate() {
    const auto last = tokens_.end() - 1;
    if (last != tokens_.begin() && ends(last[-1]) && begins(*last))
      tokens_.insert(last, {Type::newline, "\n", {}, *newline_, {}, nullptr, false});
    newline_.reset();
  }

  /// The last token goes to here, but for blanks, which TeX takes behind a command.
  void ends_here() {
    std::size_t end = at_;
    while (end > start_ && is_space(text_[end - 1])) --end;
    tokens_.back().to = static_cast<std::uint32_t>(end);
    behind_ = place_;
  }

  /// Emits a word or symbol by its Unicode text.
  void emit(Word text, Place place) {
    const Symbol& known = text.symbol();
    const bool word = known.named || known.reserved || is_letter(text[0]) || is_letter_symbol(text);
    emit(word ? Type::word : Type::symbol, text, place);
  }

  /// Returns what the templates in scope know of a word, or null.
  const OperatorWord* own(std::string_view word) const {
    const auto at = operators_.find(word);
    return at == operators_.end() ? nullptr : &at->second;
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

  /// Returns `::=`, `==`, `,,` or one ASCII character, whichever is here; nothing where it means nothing in Z.
  std::string_view ascii_symbol() const {
    static constexpr std::array<std::string_view, 3> longer = {"::=", "==", ",,"};
    for (const std::string_view symbol : longer)
      if (sees(symbol)) return symbol;
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

  /// Says whether what was read last can be the left operand of an infix operator.
  bool continues() const { return !tokens_.empty() && ends(tokens_.back()); }

  /// Calls `token`, which takes what the next token is made of, to the end of the text, and gives the tokens.
  template <class TakeToken>
  std::vector<Token> tokens(TakeToken&& token) {
    tokens_.reserve(text_.size() / 4 + 8);  // as many as spec/ has, so that none is moved
    try {
      while (!done()) {
        start_ = at_;
        token();
      }
      tokens_.push_back({Type::end, {}, {}, behind_, {}, nullptr, false});
      return std::move(tokens_);
    } catch (const ZError& error) {
      return unreadable(error);
    }
  }

  /// Gives the tokens so far, and what is wrong behind them as the last one.
  std::vector<Token> unreadable(const ZError& error) {
    tokens_.push_back({Type::error, error.what_is_wrong, {}, error.place, error.expected, nullptr, false});
    return std::move(tokens_);
  }

  /// Takes the strokes behind a word: `stroke` takes the next one while `sees_stroke`. A ₁ that makes another word of
  /// the language, as in ℕ₁, is no stroke and goes to the word.
  template <class SeesStroke, class TakeStroke>
  static std::string strokes_behind(std::string& word, SeesStroke&& sees_stroke, TakeStroke&& stroke) {
    std::string strokes;
    while (sees_stroke()) {
      const std::string mark = stroke();
      (strokes.empty() && mark == "₁" && has_indexed(word) ? word : strokes) += mark;
    }
    return strokes;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t start_ = 0;          // what is being taken begins here
  Place place_, behind_ = place_;  // behind_ is where the last token ends
  const Operators& operators_;     // the tokens point into them
  std::vector<Token> tokens_;
  std::optional<Place> newline_;
};

}  // namespace durero::zed::lexing
