#pragma once
/// Sets without variables, as the evaluator gives them.

#include <vector>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/value/value.hpp"

namespace durero::zed {

/// Says whether a set is that of all numbers, as ℝ may be in a text.
bool is_all_numbers(const Value& set);
/// Returns the members of a set that are at most so many; null where they are more, or are not listed.
const std::vector<Value>* members_up_to(const Value& set, std::size_t most);
/// Returns the members of a set that is written out. Throws Untranslated, with the term of the set, where it cannot be.
const std::vector<Value>& few_members(const Value& value, const Term& set);

}  // namespace durero::zed
