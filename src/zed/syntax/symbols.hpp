#pragma once
/// The two mark-ups of ISO Z, and the operators of its standard toolkit.
///
/// Every symbol is known by its Unicode text. What is known of an operator is a row of one table. Operator templates of
/// the toolkit are built in; a text that writes its own is refused by the parser, which keeps reading independent of
/// what has been read.

#include <optional>
#include <string>
#include <string_view>

namespace durero::zed {

/// The Unicode text of a LaTeX command (without its backslash), or nothing: `cup` gives `∪`, `dom` gives `dom`.
std::optional<std::string_view> unicode_of_command(std::string_view command);

/// The LaTeX mark-up of a symbol or word, or nothing where it is written as it is: `∪` gives `\cup`.
std::optional<std::string_view> latex_of(std::string_view unicode);

/// True for a character that joins with letters to a word (`Δ`, `Ξ`): a TeX command for it swallows the space behind.
bool is_letter_symbol(std::string_view unicode);

enum class Fixity : unsigned char { prefix, infix, postfix };
enum class Role : unsigned char { function, generic, relation };

/// `a ∪ b`: function, infix, precedence 30; `X ⇸ Y`: generic, infix, 5; `a ≤ b`: relation.
struct Operator {
  std::string_view symbol;
  Fixity fixity;
  Role role;
  int precedence = 0;        ///< of infix functions and generics: a greater one binds tighter
  bool right = false;        ///< associates to the right
  std::string name() const;  ///< the name it is known by: `_∪_`, `#_`, `_∼`
};

/// The operator of this symbol and fixity, or null.
const Operator* find_operator(std::string_view symbol, Fixity fixity);

/// The operator that a name such as `_∪_` stands for, or null.
const Operator* operator_of_name(std::string_view name);

/// True for the name of an operator, `_⦇_⦈` included.
bool is_operator_name(std::string_view name);

/// True for a symbol that is a name by itself: `∅`, `ℕ₁`, `⋃`.
bool is_symbol_name(std::string_view symbol);

/// True for a word or symbol that with a subscript 1 is another word of the language: `seq`, `ℙ`, `∃`. There the
/// subscript is no stroke.
bool has_indexed(std::string_view word);

/// The precedence of × among the infix operators (ISO/IEC 13568, 8.3).
inline constexpr int product_precedence = 8;

/// Says whether a word or symbol is reserved by the language, and so is never a name.
bool is_reserved(std::string_view word);

/// Says whether a word may be a name: it is neither reserved nor an infix or prefix operator.
bool may_be_name(std::string_view word);

}  // namespace durero::zed
