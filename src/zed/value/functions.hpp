#pragma once
/// Functions and relations are values, which are applied. The toolkit's functions are made with what is here.

#include <string>
#include <vector>

#include "zed/operators.hpp"
#include "zed/value/context.hpp"

namespace durero::zed {

/// Returns a function of the toolkit as a value. Precondition: the row is one of a function.
Value toolkit_function(const OperatorRow& row);
/// Returns a relation of the toolkit as a value: a set of pairs, or of what has the property. Precondition: the row is
/// one of a relation.
Value toolkit_relation(const OperatorRow& row);

/// Returns f(x).
Value apply_value(const Value& function, const Value& argument, Context& context);

/// Returns the values that a set which is a function relates to the argument: one, or none outside of the domain.
/// Nothing where that cannot be said.
std::optional<std::vector<Value>> value_at(const Set& function, const Value& argument, Context& context);

/// Returns the pairs of a relation whose `part`, 0 or 1, is in the set, or is not: ◁ ▷ ⩤ ⩥.
Value restricted(const Value& relation, const Value& set, std::size_t part, bool in, Context& context);
/// Returns R∼⦇S⦈.
Value inverse_image(const Value& relation, const Value& set, Context& context);

inline const Value& first(const Value& pair) { return pair.tuple()->parts[0]; }
inline const Value& second(const Value& pair) { return pair.tuple()->parts[1]; }
/// Runs where the arguments have values; else what they lack is lacking in the result.
template <class Operation>
Value with(const Value& a, Operation&& operation) {
  if (a.is_undefined()) return {};
  if (waiting(a)) return Open{};
  return operation();
}

template <class Operation>
Value with(const Value& a, const Value& b, Operation&& operation) {
  if (a.is_undefined() || b.is_undefined()) return {};
  if (waiting(a) || waiting(b)) return Open{};
  return operation();
}

}  // namespace durero::zed
