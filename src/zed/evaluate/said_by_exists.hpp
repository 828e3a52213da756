#pragma once
/// Predicates that say what an ∃ says: ∃₁, and that a set is empty. The ∃ may be decided where they are not.

#include <functional>
#include <optional>

#include "zed/evaluate/definitions.hpp"

namespace durero::zed {

/// Returns ∃ D | P • Q ∧ ¬ (∃ D′ | P′ • Q′ ∧ D′ ≠ D) for ∃₁ D | P • Q, where D′ has other names. Nothing where D
/// includes a schema or has a set that mentions one of its names, the names cannot be replaced, or P or Q binds names.
std::optional<Term> just_one_by_exists(const Node& exists_one, const Definitions& definitions);

/// Returns ¬ (∃ D | P • true) for {D | P} = ∅, and the ∃ for ≠. Nothing for another relation.
std::optional<Term> emptiness_by_exists(const Node& relation, const std::function<bool(const Name&)>& is_toolkit);

}  // namespace durero::zed
