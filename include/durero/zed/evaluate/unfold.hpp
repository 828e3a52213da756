#pragma once
/// Writes the schema calculus out: what a schema expression says as one schema text [ D | P ], in which no other schema
/// is included, and its hidden components are eliminated by the one-point rule where equations give them. So `pre Op`
/// is the precondition of Op, calculated.

#include <functional>
#include <optional>
#include <vector>

#include "durero/zed/syntax/ast.hpp"

namespace durero::zed {

/// The set of all values of the type of a component of the schema; a null term where it has no such component.
using Carriers = std::function<Term(const Name& component)>;

/// Returns the schema as a schema text; nothing where something in it is not written out: generic schemas without
/// actuals, schemas quantified by ∀ and ∃₁, and where a name would be captured. It has the same bindings.
std::optional<Term> unfolded(const Term& schema, const std::vector<Section>& sections, const Carriers& carriers);

}  // namespace durero::zed
