#pragma once
/// The parser and the printer know the signs of the language itself from here: connectives, schema operations and
/// quantifiers, by the kind of the node that they make.

#include <algorithm>
#include <iterator>
#include <string_view>

#include "durero/zed/syntax/ast.hpp"

namespace durero::zed {

/// The binding strengths rise from the weakest (ISO/IEC 13568, 8.3). An infix operator of precedence p binds with infix
/// + p.
namespace binding {
inline constexpr int weakest = 0, equivalence = 10, implication = 20, disjunction = 30, conjunction = 40, negation = 50,
                     relation = 60, conditional = 65, composition = 70, piping = 80, hiding = 90, projection = 100,
                     precondition = 110, infix = 200, prefix = 400, postfix = 410, application = 420, primary = 430;
}

/// Says whether the toolkit writes a function before its operand, as an operator, that is a name here all the same:
/// `max ran f` is max (ran f).
constexpr bool is_prefix_word(std::string_view word) { return word == "succ" || word == "min" || word == "max"; }

/// A connective stands before the one child of a node, or between the two.
struct Connective {
  Kind kind;
  std::string_view symbol;
  int strength;
  bool prefix = false;
  bool right = false;  ///< it associates to the right

  /// Says how tightly the operands bind at least.
  constexpr int left_strength() const { return right ? strength + 1 : strength; }
  constexpr int right_strength() const { return prefix || right ? strength : strength + 1; }
};

inline constexpr Connective connectives[] = {
    {Kind::equivalence, "⇔", binding::equivalence},
    {Kind::implication, "⇒", binding::implication, false, true},
    {Kind::disjunction, "∨", binding::disjunction},
    {Kind::conjunction, "∧", binding::conjunction},
    {Kind::composition, "⨟", binding::composition},
    {Kind::piping, "⨠", binding::piping},
    {Kind::projection, "⨡", binding::projection},
    {Kind::negation, "¬", binding::negation, true},
    {Kind::precondition, "pre", binding::precondition, true},
    {Kind::power, "ℙ", binding::prefix, true},
};

/// A quantifier has a schema text behind it, then • and a body.
struct Quantifier {
  Kind kind;
  std::string_view symbol;
  bool logical = false;  ///< it is of predicates and schemas, and not of expressions
};

inline constexpr Quantifier quantifiers[] = {
    {Kind::forall, "∀", true}, {Kind::exists, "∃", true}, {Kind::exists_one, "∃₁", true},
    {Kind::lambda, "λ"},       {Kind::mu, "μ"},           {Kind::let, "let"},
};

/// Returns the row of a kind of node, or null.
constexpr const Connective* connective_of(Kind kind) {
  const auto* row = std::find_if(std::begin(connectives), std::end(connectives),
                                 [kind](const Connective& connective) { return connective.kind == kind; });
  return row == std::end(connectives) ? nullptr : row;
}
constexpr const Quantifier* quantifier_of(Kind kind) {
  const auto* row = std::find_if(std::begin(quantifiers), std::end(quantifiers),
                                 [kind](const Quantifier& quantifier) { return quantifier.kind == kind; });
  return row == std::end(quantifiers) ? nullptr : row;
}

}  // namespace durero::zed
