#pragma once
/// A free type that has a value, and a constructor of values of it, has infinitely many: each is in another.

#include "zed/evaluate/inhabited.hpp"

namespace durero::zed {

/// Says whether a set is known to be infinite, by its form. Precondition: `free_types` is of these definitions.
bool is_infinite_by_form(const Term& set, const Definitions& definitions, const Inhabited& free_types);

}  // namespace durero::zed
