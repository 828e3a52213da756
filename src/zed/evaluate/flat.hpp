#pragma once
/// A flat schema is written out, for unfold.cpp: its declarations and facts include no other schema.

#include <utility>
#include <vector>

#include "zed/evaluate/definitions.hpp"

namespace durero::zed {

/// A schema text without inclusions: each name with its set, and what holds of them.
struct Flat {
  std::vector<std::pair<Name, Term>> declared;
  std::vector<Term> facts;

  const Term* set_of(const Name& name) const {
    for (const auto& [each, set] : declared)
      if (each == name) return &set;
    return nullptr;
  }
};

/// Returns name ∈ set.
Term member(const Name& name, const Term& set);

/// Adds a fact unless it is there; a conjunction is added as its conjuncts.
void add_fact(std::vector<Term>& facts, const Term& fact);

/// Returns their conjunction.
Term all_of_facts(const std::vector<Term>& facts);

/// Returns the conjunction of two schemas: a name that both declare is in both sets.
Flat merged(Flat a, const Flat& b);

/// Returns ∃ names • the schema. Names that equations determine are eliminated by the one-point rule.
Flat hidden(const Flat& of, const Components& names, const Definitions& definitions);

/// Says whether the set has every value of its type: a given set, a free type, 𝔸, and sets made of these by ℙ and ×.
bool is_whole_type(const Term& set, const Definitions& definitions);

}  // namespace durero::zed
