#pragma once
/// The operators of the toolkit on kept values. None is asked of a value that is undefined.

#include <string_view>

#include "interned_values.hpp"

namespace durero::spec {

using UnaryOperator = ValueId (*)(InternedValues& values, ValueId a);
using BinaryOperator = ValueId (*)(InternedValues& values, ValueId a, ValueId b);
using BinaryRelation = bool (*)(InternedValues& values, ValueId a, ValueId b);

/// @{ The operator of that name in the toolkit, such as `dom`, `_∪_` or `_⊆_`; null where none is here. Each throws
/// NotInterned where the evaluator is to be asked: of numbers beyond 64 bits, of sets that are not listed, and of what
/// stands outside a domain.
UnaryOperator unary_operator(std::string_view name);
BinaryOperator binary_operator(std::string_view name);
BinaryRelation binary_relation(std::string_view name);
/// @}

/// f(x): the only second part of the pairs that begin with x, and undefined where there is none, or several.
ValueId applied_pairs(const InternedValues& values, ValueId function, ValueId argument);
/// The elements of a sequence. Throws NotInterned where the set is none.
std::vector<ValueId> sequence_elements(const InternedValues& values, ValueId sequence);
/// The sequence of these elements.
ValueId sequence_of(InternedValues& values, const std::vector<ValueId>& elements);

}  // namespace durero::spec
