#pragma once
/// The names of the standard toolkit (ISO/IEC 13568, annex B) have types.

#include <unordered_map>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/types/types.hpp"

namespace durero::zed {

/// 𝔸 is the given type of all numbers.
const Type& arithmos();

/// A section sees these with the toolkit among its ancestors.
const std::unordered_map<Name, Scheme>& toolkit();

/// An expression that is typed by hand sees these, and no section does: / and √, with which its value is printed.
const std::unordered_map<Name, Scheme>& calculator();

/// Every section sees the prelude: 𝔸, ℕ and +.
const std::unordered_map<Name, Scheme>& prelude();

}  // namespace durero::zed
