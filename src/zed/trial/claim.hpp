#pragma once
/// Conjectures, as schemas that an evaluator can be asked of.

#include <cstddef>
#include <vector>

#include "durero/zed/syntax/ast.hpp"

namespace durero::zed {

/// The schemas [ D | P ], [ D | P; Q ] and [ D | P; ¬ Q ] of ∀ D | P • Q, or of ∃; where the claim begins with no
/// quantifier D and P are empty.
struct QuantifiedClaim {
  QuantifiedClaim(const Term& term, std::size_t number);
  /// Their definitions, under names that no text can write.
  std::vector<Paragraph> definitions() const;

  Term whole;
  SchemaText assumed, claimed, denied;
  bool wants_witness = false;
  Name assumed_name, claimed_name, denied_name;
};

/// Of each conjunct a name that no conjunct before it has: x of x = e, and else the one that is written last, as what
/// relates values names those that it starts from before those that it makes of them: (i, n, t) ∈ refraction.
std::vector<Name> made_by_conjuncts(const SchemaText& text);

}  // namespace durero::zed
