#pragma once
/// The least sets that satisfy the equations of free types may be empty: `L ::= node⟪L⟫` has no value to begin with.

#include <map>

#include "zed/evaluate/definitions.hpp"

namespace durero::zed {

/// The free types of a text, each with whether it has a member; open where its form does not tell.
using Inhabited = std::map<Name, Truth>;

/// Finds the free types that have members, and those that have none, by the form of their branches.
Inhabited inhabited_free_types(const Definitions& definitions);
/// Says whether a set has a member, by its form, where free types have so.
Truth has_member(const Term& set, const Definitions& definitions, const Inhabited& free_types);

}  // namespace durero::zed
