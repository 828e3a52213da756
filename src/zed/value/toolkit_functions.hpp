#pragma once
/// The rows of the table of operators (operators.hpp) name these functions, sets and relations. Each takes the values
/// of its arguments; an undefined argument makes an undefined result, an open one an open result.

#include "zed/value/context.hpp"

namespace durero::zed::functions {

// Numbers are in numbers.cpp, but for the successor, which is in sequences.cpp.
Value all_numbers();
Value all_integers();
Value naturals();
Value positive_naturals();
Value nonzero_integers();
Value addition(const Value& a, const Value& b, Context& context);
Value subtraction(const Value& a, const Value& b, Context& context);
Value multiplication(const Value& a, const Value& b, Context& context);
Value negation(const Value& a, Context& context);
Value quotient(const Value& a, const Value& b, Context& context);
Value remainder(const Value& a, const Value& b, Context& context);
Value fraction(const Value& a, const Value& b, Context& context);
Value root(const Value& a, Context& context);
/// Returns base^exponent, which no row names. Throws EvaluationError where twice the exponent is not whole, or is
/// beyond 2^21: such a power has no exact name here, or too long a one.
Value power(const Value& base, const Value& exponent, Context& context);
Value successor(const Value& number, Context& context);
Value interval(const Value& from, const Value& to, Context& context);
Value minimum(const Value& set, Context& context);
Value maximum(const Value& set, Context& context);

// Sets are in functions.cpp and spaces.cpp; sets.hpp has the rest.
Value nothing();
Value symmetric_difference(const Value& a, const Value& b, Context& context);
Value cardinality(const Value& set, Context& context);
Value nonempty_subsets(const Value& set, Context& context);
Value finite_subsets(const Value& set, Context& context);
Value nonempty_finite_subsets(const Value& set, Context& context);

// Pairs and relations are in functions.cpp.
Value maplet(const Value& a, const Value& b, Context& context);
Value first_of(const Value& pair, Context& context);
Value second_of(const Value& pair, Context& context);
Value identity(const Value& set, Context& context);
Value range(const Value& relation, Context& context);
Value inverse(const Value& relation, Context& context);
Value image(const Value& relation, const Value& set, Context& context);
Value overriding(const Value& a, const Value& b, Context& context);
Value forward_composition(const Value& a, const Value& b, Context& context);
Value backward_composition(const Value& a, const Value& b, Context& context);
Value domain_restriction(const Value& set, const Value& relation, Context& context);
Value domain_subtraction(const Value& set, const Value& relation, Context& context);
Value range_restriction(const Value& relation, const Value& set, Context& context);
Value range_subtraction(const Value& relation, const Value& set, Context& context);

// Closures and iterations are in iteration.cpp.
Value closure(const Value& relation, Context& context);
Value reflexive_closure(const Value& relation, Context& context);
/// Returns R composed so many times with itself, R ↗ n ↙, and iter n, which does that to a relation.
Value iterated(const Value& relation, const Value& times, Context& context);
Value iteration(const Value& times, Context& context);

// Sequences are in sequences.cpp.
Value sequence_of_pairs(const Value& pairs, Context& context);
Value sequences(const Value& set, Context& context);
Value nonempty_sequences(const Value& set, Context& context);
Value injective_sequences(const Value& set, Context& context);
Value head(const Value& sequence, Context& context);
Value last(const Value& sequence, Context& context);
Value tail(const Value& sequence, Context& context);
Value front(const Value& sequence, Context& context);
Value reversed(const Value& sequence, Context& context);
Value concatenation(const Value& a, const Value& b, Context& context);
Value distributed_concatenation(const Value& sequences, Context& context);
Value squashed(const Value& function, Context& context);
Value extraction(const Value& positions, const Value& sequence, Context& context);
Value filtering(const Value& sequence, const Value& set, Context& context);

}  // namespace durero::zed::functions

namespace durero::zed::relations {

Truth unequal(const Value& a, const Value& b, Context& context);
Truth element_of(const Value& a, const Value& set, Context& context);
Truth no_element_of(const Value& a, const Value& set, Context& context);
Truth proper_subset(const Value& a, const Value& b, Context& context);
Truth less(const Value& a, const Value& b, Context& context);
Truth at_most(const Value& a, const Value& b, Context& context);
Truth greater(const Value& a, const Value& b, Context& context);
Truth at_least(const Value& a, const Value& b, Context& context);
Truth is_prefix(const Value& a, const Value& b, Context& context);
Truth is_suffix(const Value& a, const Value& b, Context& context);
Truth is_infix(const Value& a, const Value& b, Context& context);
Truth is_disjoint(const Value& family, Context& context);
Truth is_partition(const Value& family, const Value& whole, Context& context);

}  // namespace durero::zed::relations
