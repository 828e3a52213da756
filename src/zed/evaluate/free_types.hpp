#pragma once
/// The values of a free type are its constants, and what its constructors make of their arguments.

#include <string>
#include <vector>

#include "zed/value/context.hpp"

namespace durero::zed {

/// A branch of a free type: a constant, or a constructor with the set of its arguments.
struct FreeBranch {
  Value name;                                  ///< an atom
  std::function<Value(Context&)> arguments{};  ///< a constant has none
};

/// The knowledge of its values that the form of a free type gives.
struct FreeTypeForm {
  bool inhabited = false;  ///< it is known to have one; where it is not, nobody may suppose one
  bool infinite = false;   ///< it is known to have infinitely many
};

/// Makes the set of all values of a free type. It is finite where each constructor is of a finite set whose members do
/// not need the free type itself, and there are at most a few thousand of them. Branches that make no value are left
/// out.
Value free_type_set(std::string name, std::vector<FreeBranch> branches, FreeTypeForm form, Context& context);

}  // namespace durero::zed
