#pragma once
/// The names of the standard toolkit (ISO/IEC 13568, annex B) and their types.

#include <unordered_map>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/types/types.hpp"

namespace durero::zed {

/// 𝔸, the given type of all numbers.
const Type& arithmos();

/// What a section sees with the toolkit among its ancestors.
const std::unordered_map<Name, Scheme>& toolkit();

/// What an expression sees that is typed by hand, and no section: / and √, with which its value is printed.
const std::unordered_map<Name, Scheme>& calculator();

/// What every section sees: 𝔸, ℕ and + (the prelude).
const std::unordered_map<Name, Scheme>& prelude();

}  // namespace durero::zed
