#pragma once
/// Sets of numbers that cannot be listed are decided along the line of numbers: whether a number is a member is the
/// same between two neighbouring roots of what the set compares (cuts.hpp).

#include <optional>

#include "zed/value/context.hpp"

namespace durero::zed {

/// Says whether every member of a is one of b. Nothing where a has no numbers, or that is not decided on their line.
std::optional<Truth> numbers_are_among(const Value& a, const Value& b, Context& context);
/// Returns the least member of a set of numbers, or the greatest; undefined where there is none. Nothing where that is
/// not decided on their line.
std::optional<Value> extreme_number(const Value& set, bool greatest, Context& context);
/// Says whether the set is known to have infinitely many members: numbers, or values of a free type.
bool is_infinite(const Value& set, Context& context);

/// Returns the members of a set of numbers as a finite set. Nothing where that is not decided on their line, or there
/// are infinitely many, or too many to be listed.
std::optional<Value> listed_numbers(const Set& set, Steps& steps);

/// Returns the kind of numbers that contains the members of both sets; an empty set changes nothing.
Numbers numbers_of_both(const Set& a, const Set& b);

/// Makes the set of integers from one to another that are too many to be listed.
Value long_interval(Real from, Real to);

}  // namespace durero::zed
