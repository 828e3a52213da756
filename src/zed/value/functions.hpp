#pragma once
/// The functions and relations of the toolkit.

#include <optional>
#include <string>
#include <vector>

#include "zed/value/context.hpp"

namespace durero::zed {

/// A function of one argument, or of a pair.
struct ToolkitFunction {
  Value (*one)(const Value&, Context&) = nullptr;
  Value (*two)(const Value&, const Value&, Context&) = nullptr;
};
/// By its name: `_∪_`, `dom`, `#_`. Null where there is none.
const ToolkitFunction* toolkit_function(const std::string& name);
/// The function as a value.
Value toolkit_value(const std::string& name);

/// Of sequences: `rev`, `_⁀_` (sequences.cpp). Null where there is none.
const ToolkitFunction* sequence_function(const std::string& name);
/// seq S, seq₁ S, iseq S: by the operator's name.
std::optional<Value> sequence_set(const std::string& name, const Value& of);

/// The pairs of a relation whose `part`, 0 or 1, is in the set, or is not: ◁ ▷ ⩤ ⩥.
Value restricted(const Value& relation, const Value& set, std::size_t part, bool in, Context& context);
/// R∼⦇S⦈
Value inverse_image(const Value& relation, const Value& set, Context& context);

/// A relation of two operands; one of a single operand (`disjoint_`) does not look at the second.
using ToolkitRelation = Truth (*)(const Value&, const Value&, Context&);
ToolkitRelation toolkit_relation(const std::string& name);
/// The relation as a value: a set of pairs, or of what is in it.
Value relation_value(const std::string& name);
Truth is_prefix(const Value& a, const Value& b, Context& context);
Truth is_suffix(const Value& a, const Value& b, Context& context);
Truth is_infix(const Value& a, const Value& b, Context& context);

/// f(x).
Value apply_value(const Value& function, const Value& argument, Context& context);

inline const Value& first(const Value& pair) { return pair.tuple()->parts[0]; }
inline const Value& second(const Value& pair) { return pair.tuple()->parts[1]; }
/// It depends on what is not known.
inline bool waiting(const Value& a) { return a.is_open() || a.get<Unknown>() || a.get<PolynomialPtr>(); }

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
