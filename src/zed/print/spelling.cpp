#include "zed/print/spelling.hpp"

#include <algorithm>
#include <array>

#include "durero/text/utf8.hpp"
#include "zed/print/printer.hpp"
#include "zed/syntax/characters.hpp"
#include "zed/syntax/symbols.hpp"

namespace durero::zed {
namespace {

/// Says whether a word may go on over a byte in Unicode, or a sign begin or end with it that is more than a bracket.
bool is_of_word(std::string_view text, char byte) {
  static constexpr std::array<std::string_view, 9> tight = {"⟨", "⟩", "⦉", "⦊", "⟪", "⟫", "⦇", "⦈", "•"};
  if (std::find(tight.begin(), tight.end(), text) != tight.end() || find_operator(text, Fixity::postfix)) return false;
  return is_letter(byte) || is_digit(byte) || byte == '_' || is_stroke(byte) ||
         static_cast<unsigned char>(byte) >= 0x80;
}

std::string_view without_index(std::string_view word) {
  static constexpr std::string_view index = "₁";
  return word.ends_with(index) ? word.substr(0, word.size() - index.size()) : word;
}

}  // namespace

std::string Spelling::unicode(const Token& token) {
  std::string text = token.type == Token::Type::stroke ? "" : token.text;
  for (const char c : token.type == Token::Type::stroke ? token.text : token.strokes) {
    if (c == '\'') {
      text += "′";
    } else {
      text += c;
    }
  }
  return text;
}

std::string Spelling::latex(const Token& token, bool behind_operand) const {
  if (token.is("-") && !behind_operand) return "\\negate";
  Printer printer(&markup_);
  if (token.type == Token::Type::stroke) {
    printer.strokes(token.text);
  } else {
    printer.tight(token.text);
    printer.strokes(token.strokes);
  }
  return printer.take();
}

bool Spelling::is_command(const Token& token) const {
  std::string text = latex(token, true);
  if (has_indexed(without_index(token.text)) && text.ends_with("_1")) text.resize(text.size() - 2);
  return text.starts_with("\\") && !is_letter_symbol(text::first(token.text)) && token.strokes.empty() &&
         std::all_of(text.begin() + 1, text.end(), is_letter);
}

bool Spelling::joins(const Token& left, const Token& right) const {
  using Type = Token::Type;
  if (left.is("↗") || right.is("↗") || right.is("↙")) return true;  // else an index, of what stands before or inside
  const bool goes_on = left.type == Type::numeral || (left.type == Type::word && !is_command(left));
  return goes_on && (right.type == Type::numeral || right.type == Type::stroke || right.is("_") ||
                     (right.type == Type::word && !is_command(right)));
}

bool Spelling::separates(const Token& left, const Token& right, bool left_negates) const {
  const std::string before = unicode(left), behind = unicode(right);
  if (is_of_word(left.text, before.back()) && is_of_word(right.text, behind.front())) return true;
  const std::string command = latex(left, !left_negates), next = latex(right, true);
  const std::size_t backslash = command.rfind('\\');
  return backslash != command.npos && (is_letter(next.front()) || is_digit(next.front())) &&
         backslash + 1 < command.size() &&
         std::all_of(command.begin() + static_cast<std::ptrdiff_t>(backslash) + 1, command.end(), is_letter);
}

}  // namespace durero::zed
