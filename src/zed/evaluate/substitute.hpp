#pragma once
/// Substitution puts terms in the place of free names.

#include <map>
#include <optional>

#include "zed/evaluate/definitions.hpp"

namespace durero::zed {

/// Returns the term with these terms in the place of the free names. Returns nothing where the term would bind a name
/// of one of them, or where it refers to a replaced name through a schema: as a component behind θ, in an included
/// schema or in a schema that stands as a predicate.
std::optional<Term> substituted(const Term& term, const std::map<Name, Term>& by, const Definitions& definitions);

/// Says whether the name is free in the term, or may be, through a schema.
bool depends_on(const Term& term, const Name& name, const Definitions& definitions);

}  // namespace durero::zed
