#include "zed/syntax/command_hints.hpp"
#include "zed/syntax/lexer_base.hpp"

namespace durero::zed {
namespace lexing {
namespace {

class Latex : Lexer {
 public:
  Latex(const Block& block, const Markup& markup, const Operators& operators)
      : Lexer(block.body, block.place, operators), markup_(markup), spivey_(block.spivey.get()) {
    spaces();
    named_ = block.environment != "schema" || here() == '{';
  }

  std::vector<Token> run() {
    if (!named_) return unreadable({place_, "a schema without a name", "expected {NAME}"});
    return tokens([this] { token(); });
  }

 private:
  void token() {
    const char c = here();
    if (is_space(c) || c == '~') {
      take();
    } else if (c == '{' || c == '}' || (c == '^' && here(1) == '{')) {
      brace();
    } else if (c == '%') {
      if (spivey_ != nullptr && place_.column == 1 && is_hidden_line(text_.substr(at_, text_.find('\n', at_) - at_)))
        take(2);
      else
        comment();
    } else if (is_letter(c)) {
      word({}, place_);
    } else if (is_digit(c)) {
      number();
    } else if (is_stroke(c) || c == '_') {
      const Place place = place_;
      emit(Type::stroke, stroke(), place);
    } else if (c == '\\') {
      command();
    } else {
      plain();
    }
  }

  /// Takes a brace: those of ^{ } are the signs of an iteration where the ^ is no word's, and others only group, in
  /// TeX.
  void brace() {
    const Place place = place_;
    if (here() == '}') {
      const bool raises = !braces_.empty() && braces_.back();
      if (!braces_.empty()) braces_.pop_back();
      take();
      if (raises) emit("↙", place);
      return;
    }
    braces_.push_back(here() == '^');
    take(braces_.back() ? 2 : 1);
    if (braces_.back()) emit("↗", place);
  }

  void plain() {
    const Place place = place_;
    if (here() == '@') {
      take();
      return emit("•", place);
    }
    if (sees("..")) {
      take(2);
      return emit("‥", place);
    }
    if (spivey_ != nullptr && is_layout()) return void(take());
    const std::string_view symbol = ascii_symbol();
    if (symbol.empty()) {
      const std::string character(text::first(text_.substr(at_)));
      refuse(place, "the character " + character + " means nothing here",
             character == "#" ? "expected \\#, as LaTeX writes it" : "expected LaTeX mark-up of Z");
    }
    emit(Type::symbol, std::string(take(symbol.size())), place);
    tokens_.back().only_infix = symbol == "-" && spivey_ == nullptr;
  }

  /// Says whether Spivey's Z has a sign here for the eye alone: what aligns, a quotation mark, and the full stop or
  /// comma that ends a sentence with the paragraph.
  bool is_layout() const {
    if (here() == '&' || here() == '"') return true;
    if (here() != '.' && here() != ',') return false;
    const std::size_t next = text_.find_first_not_of(" \t\r\n", at_ + 1);
    return next == text_.npos || text_.substr(next).starts_with("\\also");
  }

  /// Takes one stroke, of which the first character is here.
  std::string stroke() {
    const Place place = place_;
    if (is_stroke(here())) return std::string(take());
    take();
    const bool braced = here() == '{';
    if (braced) take();
    if (!is_digit(here()))
      refuse(place, "this subscript is not read", "expected one digit after _, or it behind a name");
    const std::string_view digit = digits[static_cast<std::size_t>(here() - '0')];
    take();
    if (is_digit(here()) || (braced && here() != '}'))
      refuse(place, "this subscript is not read", "expected one digit after _, or braces");
    if (braced) take();
    return std::string(digit);
  }

  /// Says whether a subscript or superscript is here that is part of a word; one digit below is a stroke.
  bool sees_raised() const {
    if (here() == '^') return true;
    const std::size_t inside = here(1) == '{' ? 2 : 1;
    const bool digit = is_digit(here(inside)) && (inside == 1 || here(3) == '}');
    return here() == '_' && !digit;
  }

  /// Takes `_{max}` or `^{2}`, which are ↘max↖ and ↗2↙ in Unicode (ISO/IEC 13568, 7.4.2).
  std::string raised() {
    const Place place = place_;
    const bool below = take() == "_";
    const bool braced = here() == '{';
    if (braced) take();
    std::string inside;
    while ((braced || inside.empty()) && more_inside(inside)) {
    }
    if (inside.empty() || (braced && here() != '}'))
      refuse(place, "this index is not read",
             std::string("expected letters and digits in { } behind _ or ^") +
                 (below ? "" : ", or ~ before ^ for an iteration: R~^{~n~}"));
    if (braced) take();
    return (below ? "↘" : "↗") + inside + (below ? "↖" : "↙");
  }

  /// Takes one more letter or digit of an index, if one is here.
  bool more_inside(std::string& inside) {
    if (here() == '_' || here() == '^') return false;  // an index has none of its own
    if (!is_digit(here())) return more_of_word(inside);
    inside += take();
    return true;
  }

  /// Takes the blanks here where what stands behind them goes on the word or numeral before them. In this mark-up a
  /// blank is no space (ISO/IEC 13568, A.2), so that `f a` is the name fa; `~` or a command separates.
  template <class GoesOn>
  bool over_blanks(GoesOn goes_on) {
    if (spivey_ != nullptr) return goes_on();  // there a blank separates
    const std::size_t at = at_;
    const Place place = place_;
    spaces();
    if (goes_on()) return true;
    at_ = at;
    place_ = place;
    return false;
  }

  void number() {
    const Place place = place_;
    std::string digits(take());
    while (over_blanks([this] { return is_digit(here()); })) digits += take();
    emit(Type::numeral, std::move(digits), place);
  }

  std::string strokes(std::string& word) {
    const auto is_here = [this] { return is_stroke(here()) || (here() == '_' && !sees_raised()); };
    const auto sees_stroke = [&] { return over_blanks(is_here); };
    return strokes_behind(word, sees_stroke, [this] { return stroke(); });
  }

  /// Takes the letters of a word; `begun` has those that are taken already.
  void word(std::string begun, Place place) {
    do {
      begun += letters();
    } while (over_blanks([&] { return more_of_word(begun); }));
    const Place decorated = place_;
    const std::size_t end = at_;
    std::string behind = strokes(begun);
    const bool decorates = spivey_ != nullptr && !behind.empty() && spivey_->schemas.contains(begun);
    if (!decorates) {
      const bool names = spivey_ != nullptr && is_name_of_spivey(begun, *spivey_);
      emit(Type::word, std::move(begun), place, std::move(behind));
      if (names) tokens_.back().call_name();
      return;
    }
    emit(Type::word, std::move(begun), place);
    tokens_.back().to = static_cast<std::uint32_t>(end);
    start_ = end;
    emit(Type::stroke, std::move(behind), decorated);
  }

  /// Takes one more letter of the word, if one is here.
  bool more_of_word(std::string& begun) {
    if (is_letter(here()) || (is_digit(here()) && !begun.empty())) {
      begun += take();
    } else if (sees("\\_")) {
      take(2);
      begun += '_';
    } else if (!begun.empty() && (here() == '^' || here() == '_') && sees_raised()) {
      begun += raised();
    } else if (here() == '\\') {
      const auto letter = letter_command(command_here());
      if (letter) begun += *letter;
      return letter.has_value();
    } else {
      return false;
    }
    return true;
  }

  std::string_view command_name() const {
    if (here() != '\\') return {};
    std::size_t length = 1;
    while (is_letter(here(length))) ++length;
    if (length == 1) length = 1 + text::first(text_.substr(std::min(at_ + 1, text_.size()))).size();
    const std::string_view name = text_.substr(at_ + 1, length - 1);
    return name == "vdash" && here(length) == '?' ? text_.substr(at_ + 1, length) : name;
  }

  /// A command has a meaning by a directive of the text, or else by ISO Z; or it has none.
  struct Command {
    std::string_view name;
    std::optional<std::string_view> meaning;
    bool own = false;
  };
  Command command_here() const {
    const std::string_view name = command_name();
    if (const auto own = markup_.find(name); own != markup_.end()) return {name, own->second, true};
    if (spivey_ != nullptr)
      if (const auto meaning = spivey_command(name)) return {name, meaning};
    const auto meaning = unicode_of_command(name);
    return {name, meaning || name != "defs" ? meaning : spivey_command(name)};
  }

  /// Takes a command for a letter that joins with others, and the spaces that TeX drops behind it.
  std::optional<std::string_view> letter_command(const Command& here) {
    if (!here.meaning || !(here.own ? is_one_letter(*here.meaning) : is_letter_symbol(*here.meaning))) return {};
    take(1 + here.name.size());
    spaces();
    return here.meaning;
  }

  /// Says whether the text of a command is one character that joins with letters, and no operator's word.
  bool is_one_letter(std::string_view text) const {
    return text::first(text) == text && is_other_letter(text) && !own(text);
  }

  void command() {
    const Place place = place_;
    const Command command = command_here();
    if (const auto letter = letter_command(command)) return word(std::string(*letter), place);
    const std::string_view name = command.name;
    take(1 + name.size());
    static constexpr std::array<std::string_view, 7> blanks = {",", ";", ":", "!", " ", "quad", "qquad"};
    static constexpr std::array<std::string_view, 4> breaks = {"\\", "also", "znewpage", "zbreak"};
    if (command.meaning && command.meaning->empty()) {
    } else if (command.meaning && !command.own) {  // the others, which ISO Z gives no meaning, are layout
      known(command, place);
    } else if (among(name, blanks) || name == "\n") {
    } else if (among(name, breaks)) {
      newline(place);
    } else if (name == "t" && is_digit(here())) {
      while (is_digit(here())) take();
    } else if (name == "where") {
      emit("|", place);
    } else if (name == "&") {
      emit("&", place);
    } else {
      known(command, place);
    }
  }

  void known(const Command& command, Place place) {
    if (!command.meaning)
      refuse(place, "unknown command \\" + std::string(command.name), expected_command(command.name, markup_));
    if (command.name == "negate" && continues()) {
      if (!newline_) refuse(place, "\\negate takes no left operand", "expected - for the difference");
      tokens_.push_back({Type::newline, "\n", {}, *newline_, {}, nullptr, false});
    }
    std::string text(*command.meaning);
    if (here() == '_' || (is_stroke(here()) && bears_strokes(text))) {
      std::string after = strokes(text);
      if (!after.empty()) return emit(Type::word, std::move(text), place, std::move(after));
    }
    if (command.own) return words_of_directive(text, place);
    emit(text, place);
  }

  /// Emits the words that a directive gives a command, with a blank between two.
  void words_of_directive(std::string_view text, Place place) {
    while (!text.empty()) {
      const std::string_view word = text.substr(0, text.find(' '));
      text.remove_prefix(std::min(text.size(), word.size() + 1));
      const bool is_sign = static_cast<unsigned char>(word[0]) < 0x80 && !is_letter(word[0]);
      if (is_sign || latex_of(word))
        emit(word, place);
      else
        emit(Type::word, std::string(word), place);
    }
  }

  const Markup& markup_;
  const SpiveyText* spivey_;
  bool named_ = true;
  std::vector<bool> braces_;  // those that are open: whether each is of a ^{
};

}  // namespace
}  // namespace lexing

std::vector<Token> lex_latex(const Block& block, const Markup& markup, const Operators& operators) {
  return lexing::Latex(block, markup, operators).run();
}

std::vector<Token> lex(const Block& block, const Markup& markup, const Operators& operators) {
  return block.unicode ? lex_unicode(block.body, operators, block.place) : lex_latex(block, markup, operators);
}

}  // namespace durero::zed
