#pragma once
/// Definitions by cases give a function one equation for each form of argument, `f(0) = 1`, `f(n + 1) = e` or `∀ l, r :
/// T | P • size(fork(l, r)) = e`. Each is brought to one form, `∀ x | x has the form • f(x) = e`. Statements about the
/// members of a set, `leaf ∈ S` or `(a, b) ∈ S ⇔ P`, become such clauses of a function whose value is 1 there, and else
/// 0.

#include <vector>

#include "durero/zed/syntax/ast.hpp"

namespace durero::zed {

/// A name that no text can write, for a set that has every value of a type.
inline const Name any_value{"any value", ""};

/// The cases of a name in some predicates.
struct Cases {
  std::vector<Term> clauses;  ///< ∀ D | P • f(x) = e, in the order of the text
  bool all_said = true;       ///< every predicate that mentions the name is among them, or an equation for its domain
};

/// Finds the equations for applications of a function in these predicates. An equation whose arguments are all the
/// names of D stands as in the text.
Cases cases_of_function(const std::vector<Predicate>& predicates, const Name& function);
/// Finds the statements about the members of a set, or of a relation between two of its operands.
Cases cases_of_set(const std::vector<Predicate>& predicates, const Name& set);

}  // namespace durero::zed
