#pragma once
/// Relations bound variables: x = e, x ∈ S, x ⊆ S, # x ≤ n, x prefix s, x ⁀ y = s and x ∪ y = S leave finitely many
/// values for x where the other side is known.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "zed/evaluate/search.hpp"

namespace durero::zed {

/// An operand of a relation, as it is written and compiled.
struct Operand {
  Term term;
  Code code;
};

/// A relation of the toolkit between two operands.
struct RelationOf {
  std::string word;
  Operand left, right;
};

/// Returns what the relation bounds, if anything. `slot` gives the slot of a term that is a variable, and `is_toolkit`
/// says whether a name means what it does in the toolkit.
std::vector<ValueBound> bounds_of(const RelationOf& relation,
                                  const std::function<std::optional<unsigned>(const Term&)>& slot,
                                  const std::function<bool(const Name&)>& is_toolkit);

/// Returns the bounds of a property: those of its conjuncts, and for a disjunction those that each side has.
std::vector<ValueBound> collected_bounds(const Property& property);

/// Returns small numbers, the nearest to 0 first, then the numerals that the conjuncts of the property name, with their
/// neighbours.
std::vector<Real> small_numbers(const Property& property);

}  // namespace durero::zed
