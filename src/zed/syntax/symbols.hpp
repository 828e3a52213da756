#pragma once
/// Symbols have a spelling in each of the two mark-ups of ISO Z, and operators of its standard toolkit have a role.
///
/// Every symbol is known by its Unicode text. What is known of an operator is a row of one table. Operator templates of
/// the toolkit are built in; those that a text writes are in its Operators.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "durero/zed/syntax/operators.hpp"

namespace durero::zed {

/// Returns the Unicode text of a LaTeX command (without its backslash), or nothing: `cup` gives `∪`, `dom` gives `dom`.
std::optional<std::string_view> unicode_of_command(std::string_view command);

/// Returns the LaTeX mark-up of a symbol or word, or nothing where it is written as it is: `∪` gives `\cup`.
std::optional<std::string_view> latex_of(std::string_view unicode);

/// Returns every command of LaTeX, without its backslash, with its Unicode text.
std::vector<std::pair<std::string_view, std::string_view>> command_spellings();

/// Says whether a character joins with letters to a word, as `Δ` and `Ξ` do: a TeX command for it swallows the space
/// behind.
bool is_letter_symbol(std::string_view unicode);

enum class Fixity : unsigned char { prefix, infix, postfix };

/// In `a ∪ b` stands a function, infix, of precedence 30; in `X ⇸ Y` a generic, infix, of precedence 5; in `a ≤ b` a
/// relation.
struct Operator {
  std::string_view symbol;
  Fixity fixity;
  Role role;
  int precedence = 0;        ///< infix functions and generics have one: a greater one binds tighter
  bool right = false;        ///< it associates to the right
  std::string name() const;  ///< it is known by this: `_∪_`, `#_`, `_∼`
};

struct Connective;
struct Quantifier;

/// What the language and its toolkit know of a word or symbol: most words are names, of which they know nothing.
struct Symbol {
  const Operator *prefix = nullptr, *infix = nullptr, *postfix = nullptr;
  const Connective* connective = nullptr;
  const Quantifier* quantifier = nullptr;
  bool reserved = false;  ///< by the language, and so it is never a name
  bool named = false;     ///< it is a name by itself: `∅`, `ℕ₁`, `⋃`

  /// Says whether it may be a name: it is neither reserved nor an infix or prefix operator.
  constexpr bool may_be_name() const { return !reserved && !infix && !prefix; }
};
inline constexpr Symbol no_symbol;

/// Returns what is known of a word or symbol; of most words that is `no_symbol`.
const Symbol& symbol_of(std::string_view text);

/// Returns the operator of this symbol and fixity, or null.
const Operator* find_operator(std::string_view symbol, Fixity fixity);

/// Returns the operator that a name such as `_∪_` stands for, or null.
const Operator* operator_of_name(std::string_view name);

/// Says whether this is the name of an operator, as `_⦇_⦈` is too, and what a template gives.
bool is_operator_name(std::string_view name);

/// Says whether a symbol is a name by itself: `∅`, `ℕ₁`, `⋃`.
inline bool is_symbol_name(std::string_view symbol) { return symbol_of(symbol).named; }

/// Says whether a word or symbol is with a subscript 1 another word of the language, as `seq`, `ℙ` and `∃` are. There
/// the subscript is no stroke.
bool has_indexed(std::string_view word);

/// This is the precedence of × among the infix operators (ISO/IEC 13568, 8.3).
inline constexpr int product_precedence = 8;

/// Says whether a word may be a name: it is neither reserved nor an infix or prefix operator.
inline bool may_be_name(std::string_view word) { return symbol_of(word).may_be_name(); }

}  // namespace durero::zed
