#pragma once
/// Puts terms for names.

#include <map>
#include <optional>

#include "zed/evaluate/definitions.hpp"

namespace durero::zed {

/// Returns the term with these terms for the free names. Nothing where a name of one of them would be bound by the
/// term, or where the term speaks of a name through a schema: as a component behind θ, in an included schema or a
/// schema that stands as a predicate.
std::optional<Term> substituted(const Term& term, const std::map<Name, Term>& by, const Definitions& definitions);

/// Says whether the name is free in the term, or may be, through a schema.
bool depends_on(const Term& term, const Name& name, const Definitions& definitions);

}  // namespace durero::zed
