#pragma once
/// Whether facts at hand say that something is a member of a set, for the checks beyond types.

#include "zed/review/expand.hpp"

namespace durero::zed {

/// What holds at a place.
struct Facts {
  std::vector<Term> facts;
  std::map<Name, Term> declared;  // a name and the set it is declared from
};

/// dom f
Term domain_of(const Term& function);

/// x ∈ S from the facts, in the few steps that partial_applications() promises.
bool proves_member(const Term& x, const Term& set, const Expander& expander, const Facts& facts, Budget& budget);

}  // namespace durero::zed
