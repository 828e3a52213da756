/// The lexers of the two mark-ups share what is here: which tokens a line break separates, and labels.

#include "zed/syntax/connectives.hpp"
#include "zed/syntax/lexer_base.hpp"

namespace durero::zed::lexing {

bool bears_strokes(std::string_view word) { return (is_letter(word[0]) || is_symbol_name(word)) && may_be_name(word); }

bool is_other_letter(std::string_view character) {
  static constexpr std::array<std::string_view, 4> indices = {"↘", "↖", "↗", "↙"};
  if (character.empty() || static_cast<unsigned char>(character[0]) < 0x80) return false;
  const bool punctuation = character >= "\u2000" && character <= "\u206F";
  const bool sign = character >= "\u2190" && character <= "\u2BFF";
  return among(character, indices) || !(punctuation || sign);
}

bool ends(const Token& token) {
  if (token.own) return token.own->last() && !token.own->of->has_right();
  if (token.type == Type::numeral || token.type == Type::stroke) return true;
  if (token.type == Type::newline || token.type == Type::end) return false;
  if (token.symbol->postfix || token.text == "⦈" || token.text == "↙") return true;
  if (token.type == Type::symbol) return among(token.text, closing);
  if (!token.strokes.empty() || token.text == "true" || token.text == "false") return true;
  return token.symbol->may_be_name();
}

namespace {

/// Says whether a sign stands before all of its operands.
bool leads(const Token& sign) {
  const Symbol& known = *sign.symbol;
  return known.quantifier || (known.connective && known.connective->prefix) || sign.text == "θ" || sign.text == "if" ||
         sign.text == "⊢?";
}

}  // namespace

bool begins(const Token& token) {
  if (token.type == Type::numeral) return true;
  if (token.type != Type::word && token.type != Type::symbol) return false;
  if (token.own) return token.own->first() && !token.own->of->has_left();
  if (token.symbol->infix) return false;
  if (token.text == "_") return true;  // an operand of an operator that is declared or defined
  if (among(token.text, opening) || leads(token) || token.symbol->prefix) return true;
  return token.type == Type::word && token.text != "then" && token.text != "else";
}

std::string label_in(std::string_view comment) {
  const auto is_blank = [](char c) { return is_space(c) || c == '%'; };
  while (!comment.empty() && is_blank(comment.front())) comment.remove_prefix(1);
  while (!comment.empty() && is_space(comment.back())) comment.remove_suffix(1);
  const std::size_t first = comment.find('.'), second = comment.rfind('.');
  if (first == 0 || first == comment.npos || first == second) return {};
  const std::string_view schema = comment.substr(0, first), number = comment.substr(second + 1);
  static constexpr std::array<std::string_view, 6> kinds = {"pre", "post", "inv", "def", "axiom", "conj"};
  if (!among(comment.substr(first + 1, second - first - 1), kinds) || number.empty()) return {};
  const bool named =
      std::all_of(schema.begin(), schema.end(), [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
  return named && std::all_of(number.begin(), number.end(), is_digit) ? std::string(comment) : std::string();
}

}  // namespace durero::zed::lexing
