#pragma once
/// The tokens of Z are the same from either mark-up.

#include <cstdint>
#include <string>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/syntax/operators.hpp"
#include "zed/syntax/symbols.hpp"

namespace durero::zed {

struct Token {
  enum class Type : unsigned char {
    word,     ///< a name, or an operator or keyword made of letters: `dom`, `div`, `if`
    numeral,  ///< decimal digits
    symbol,   ///< anything else, by its Unicode text: `∪`, `::=`, `(`
    stroke,   ///< a stroke that stands by itself, as in `(S)'`
    newline,  ///< a line break that separates
    end,      ///< behind the last token
    error,    ///< what cannot be read, as the last token: text says what is wrong, label what is expected
  };
  Type type = Type::end;
  Word text;     ///< it is written in Unicode
  Word strokes;  ///< a word has them
  Place place;
  std::string label;                  ///< the last token of a line has the label in the comment that ends it
  const OperatorWord* own = nullptr;  ///< a template in scope makes the word one of an operator
  bool only_infix = false;            ///< LaTeX mark-up reserves such a `-` for the difference; the sign is \negate
  std::uint32_t from = 0, to = 0;     ///< its bytes in the text that was read, but for blanks behind it
  const Symbol* symbol =
      &no_symbol;          ///< what is known of a word or symbol without strokes, which is none of a template
  bool only_name = false;  ///< in Spivey's Z a word is a name that is a keyword or an operator of ISO's

  bool is(std::string_view sign) const {
    return (type == Type::symbol || (type == Type::word && strokes.empty() && !only_name)) && text == sign;
  }

  /// Makes a word a name, whatever ISO's language and toolkit know of it.
  void call_name() {
    only_name = own == nullptr;
    if (only_name) symbol = &no_symbol;
  }
};

}  // namespace durero::zed
