#pragma once
/// Definitions by cases. What a box says of one form of argument, `f(0) = 1`, `f(n + 1) = e` or
/// `∀ l, r : T | P • size(fork(l, r)) = e`, is brought to one form, `∀ x | x has it • f(x) = e`; and what it says of
/// the members of a set, `leaf ∈ S` or `(a, b) ∈ S ⇔ P`, to one of a function whose value is 1 there, and else 0.

#include <vector>

#include "durero/zed/syntax/ast.hpp"

namespace durero::zed {

/// No text can write this name: it has every value of a type.
inline const Name any_value{"any value", ""};

/// What predicates say of a name, case by case.
struct Cases {
  std::vector<Term> clauses;  ///< ∀ D | P • f(x) = e, in the order of the text
  bool all_said = true;       ///< every predicate that mentions the name is among them, or an equation for its domain
};

/// Finds what these predicates say of a function, by equations for its applications. Of one that the names of D are the
/// arguments of, the clause is as the text has it.
Cases cases_of_function(const std::vector<Predicate>& predicates, const Name& function);
/// Finds what they say of a set, or of a relation between two of its operands.
Cases cases_of_set(const std::vector<Predicate>& predicates, const Name& set);

}  // namespace durero::zed
