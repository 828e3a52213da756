#pragma once
/// The kinds of set of the toolkit.

#include <string>
#include <vector>

#include "zed/operators.hpp"
#include "zed/value/context.hpp"

namespace durero::zed {

/// A finite set of sorted members, each once.
Value finite(std::vector<Value> sorted);
const Value& empty_set();

/// 𝔸 and ℝ, and the given sets: whatever stands there is a member.
Value everything(std::string name);
/// ℤ, ℕ, ℕ₁.
Value integers(std::string name, std::optional<int> least);

/// ℙ S, ℙ₁ S, 𝔽 S, 𝔽₁ S.
struct PowerForm {
  bool finite = false, nonempty = false;
};
Value power_set(Value base, PowerForm form);
Value product_set(std::vector<Value> factors);

/// The set of the relations or functions that an arrow makes: `from ⇸ to`. `symbol` is what it is printed with.
Value function_set(Value from, Value to, const Arrow& arrow, std::string_view symbol);

/// The function that makes the values of one branch of a free type, of the branch's arguments.
Value constructor_function(std::string type, std::string name, std::uint32_t order, Value arguments);

// Below, a finite result where the arguments allow one, and an intensional one otherwise.
Value set_union(const Value& a, const Value& b, Context& context);
Value intersection(const Value& a, const Value& b, Context& context);
Value set_difference(const Value& a, const Value& b, Context& context);
Value big_union(const Value& a, Context& context);
Value big_intersection(const Value& a, Context& context);
/// The set of first parts of a relation's pairs, or the domain of a function known by its values.
Value domain(const Value& relation, Context& context);

/// S ⊆ T.
Truth subset(const Value& a, const Value& b, Context& context);

/// The members of a finite set. Throws EvaluationError where it is not one, which names what is done to it.
const std::vector<Value>& enumerated(const Value& value, const char* what);

}  // namespace durero::zed
