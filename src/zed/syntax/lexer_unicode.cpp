#include "zed/syntax/lexer_base.hpp"

namespace durero::zed {
namespace lexing {
namespace {

class Unicode : Lexer {
 public:
  Unicode(std::string_view text, const Operators& operators, Place place) : Lexer(text, place, operators) {}

  std::vector<Token> run() {
    return tokens([this] { token(); });
  }

 private:
  void token() {
    const char c = here();
    if (is_space(c)) {
      if (c == '\n') newline(place_);
      take();
    } else if (box_sign()) {
    } else if (c == '%') {
      comment();
    } else if (is_digit(c)) {
      number();
    } else if (c == '"') {
      quoted();
    } else if (sees_stroke()) {
      const Place place = place_;
      emit(Type::stroke, stroke(), place);
    } else if (is_letter(c) || is_word_character()) {
      word();
    } else {
      symbol();
    }
  }

  /// Takes `12`, or `0.25`; in `t.1.2` the second point selects.
  void number() {
    const bool selects = !tokens_.empty() && tokens_.back().is(".");
    numeral();
    if (selects || here() != '.' || !is_digit(here(1))) return;
    tokens_.back().text += take();
    while (is_digit(here())) tokens_.back().text += take();
    ends_here();
  }

  /// Takes `"a-b"`, a name of letters, digits and `_ . : -`; its word keeps the quotation marks.
  void quoted() {
    const Place place = place_;
    std::string name(take());
    const auto spells = [](char c) {
      return is_letter(c) || is_digit(c) || c == '_' || c == '.' || c == ':' || c == '-';
    };
    while (spells(here())) name += take();
    if (here() != '"' || name.size() == 1)
      refuse(place_, "a quoted name ends here", "expected letters, digits and _ . : - between two quotation marks");
    name += take();
    emit(Type::word, std::move(name), place);
  }

  std::string_view character() const { return text::first(text_.substr(std::min(at_, text_.size()))); }

  bool sees_stroke() const {
    const std::string_view c = character();
    return is_stroke(here()) || c == "′" || among(c, digits);
  }

  std::string stroke() { return character() == "′" ? (take(), "'") : std::string(take()); }

  /// Says whether a letter is here that is no symbol: outside ASCII, that is whatever this reader does not know as a
  /// symbol.
  bool is_word_character() const {
    const std::string_view c = character();
    if (c.size() < 2 || sees_stroke()) return false;  // it is ASCII, or a byte that is no character
    static constexpr std::array<std::string_view, 10> others = {"•", "⦁", "−", "⊢", "λ", "μ", "θ", "…", "⁀", "‥"};
    if (among(c, others)) return c == "λ" || c == "μ" || c == "θ";
    if (is_symbol_name(c)) return false;
    return is_letter_symbol(c) || (!latex_of(c) && is_other_letter(c));
  }

  /// Says whether a sign is here that the toolkit does not know, and that a template may make an operator.
  bool sees_other_sign() const {
    const std::string_view c = character();
    return c.size() == 3 && c >= "\u2190" && c <= "\u2BFF" && c != "⦁" && !latex_of(c);
  }

  /// Takes a sign of a box: │ and ─ are blanks, and ├ stands between declarations and predicates.
  bool box_sign() {
    const Place place = place_;
    if (sees("├")) {
      take(std::string_view("├").size());
      emit("|", place);
    } else if (sees("│") || sees("─")) {
      take(std::string_view("│").size());
    } else {
      return false;
    }
    return true;
  }

  void word() {
    const Place place = place_;
    std::string letters;
    while (is_letter(here()) || is_digit(here()) || here() == '_' || is_word_character()) letters += take();
    if (letters == "↗" || letters == "↙") return emit(letters, place);  // those of R ↗ n ↙ stand alone
    emit_with_strokes(std::move(letters), place);
  }

  void emit_with_strokes(std::string text, Place place) {
    std::string strokes = strokes_behind(
        text, [this] { return sees_stroke(); }, [this] { return stroke(); });
    if (!strokes.empty()) return emit(Type::word, std::move(text), place, std::move(strokes));
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
    if (sees_other_sign()) return emit(Type::word, std::string(take()), place);
    if (!latex_of(character()) || static_cast<unsigned char>(here()) < 0x80)
      refuse(place, "the character " + std::string(character()) + " means nothing here", "expected Z in Unicode");
    std::string text(take());
    if (has_indexed(text) || is_symbol_name(text)) return emit_with_strokes(std::move(text), place);
    emit(text, place);
  }
};

}  // namespace
}  // namespace lexing

std::vector<Token> lex_unicode(std::string_view text, const Operators& operators, Place place) {
  return lexing::Unicode(text, operators, place).run();
}

}  // namespace durero::zed
