#pragma once
/// The toolkit has these kinds of set.

#include <algorithm>
#include <string>
#include <vector>

#include "zed/operators.hpp"
#include "zed/value/context.hpp"

namespace durero::zed {

/// Says whether a stands before b among the members of a finite set.
inline bool precedes(const Value& a, const Value& b) { return compare(a, b) < 0; }
/// Sorts values.
inline std::vector<Value> sorted(std::vector<Value> values) {
  std::sort(values.begin(), values.end(), precedes);
  return values;
}

/// Makes a finite set of members that are sorted, each once.
Value finite(std::vector<Value> sorted);
/// Makes the finite set of the pairs of a sequence, which is written as one. Precondition: their first parts are 1‥n in
/// this order.
Value finite_sequence(std::vector<Value> pairs);
const Value& empty_set();

/// Makes a set of which every value of its type is a member: 𝔸, ℝ, a given set.
Value everything(std::string name);
/// Makes a given set of this name.
Value given_set(std::string name);
/// Makes the set of all real numbers, which is such a set too.
Value reals(std::string name);
/// Makes ℤ, ℕ or ℕ₁: the integers from the least one, if any.
Value integers(std::string name, std::optional<int> least);
/// Returns the least member of ℤ, ℕ or ℕ₁, or that there is none; null where the set is none of these.
const std::optional<int>* integers_from(const Set& set);

/// The forms of a power set are ℙ S, ℙ₁ S, 𝔽 S and 𝔽₁ S.
struct PowerForm {
  bool finite = false, nonempty = false;
};
Value power_set(Value base, PowerForm form);
Value product_set(std::vector<Value> factors);

/// Makes the set of relations or functions that an arrow stands for: `from ⇸ to`. It is printed with `symbol`.
Value function_set(Value from, Value to, const Arrow& arrow, std::string_view symbol);

/// Makes the function from the arguments of a free type's branch to the values of that type.
Value constructor_function(std::string type, std::string name, std::uint32_t order, Value arguments);

// The results below are finite where the arguments allow it, and intensional otherwise.
Value set_union(const Value& a, const Value& b, Context& context);
Value intersection(const Value& a, const Value& b, Context& context);
Value set_difference(const Value& a, const Value& b, Context& context);
Value big_union(const Value& a, Context& context);
Value big_intersection(const Value& a, Context& context);
/// Returns the set of first parts of a relation's pairs, or the domain of a function known by its values.
Value domain(const Value& relation, Context& context);

/// Says whether S ⊆ T.
Truth subset(const Value& a, const Value& b, Context& context);

/// Returns the members of a finite set. Throws EvaluationError, which names what is done to it, where it is none.
const std::vector<Value>& enumerated(const Value& value, const char* what);

}  // namespace durero::zed
