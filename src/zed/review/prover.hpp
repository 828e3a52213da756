#pragma once
/// A prover derives memberships from the facts at hand, for the checks beyond types.

#include "zed/review/expand.hpp"

namespace durero::zed {

/// The facts are the predicates that hold at a place of the text.
struct Facts {
  std::vector<Term> facts;
  std::unordered_map<Name, Term> declared;  // each name has the set that it is declared from
};

/// Makes the term dom f.
Term domain_of(const Term& function);

/// Says whether the facts give x ∈ S in the few steps that partial_applications() promises.
bool proves_member(const Term& x, const Term& set, const Expander& expander, const Facts& facts, Budget& budget);

}  // namespace durero::zed
