#pragma once
/// Says how the printer sees a node: by which operator it is printed, and how tightly that binds.

#include <string_view>
#include <utility>

#include "durero/zed/syntax/ast.hpp"
#include "zed/syntax/symbols.hpp"

namespace durero::zed {

/// Returns the operator that an application or a reference is printed with, or null where it is printed as such.
const Operator* operator_of(const Node& node);
int operator_strength(const Operator& op);

/// Returns the signs around the right operand where the node is an application R ⦇ S ⦈ or R ↗ n ↙; else empty ones.
std::pair<std::string_view, std::string_view> enclosing_signs(const Node& node);

/// Returns the pairs of the sequence that an application of ⟨,,⟩ stands for, or null. The elements are the second parts
/// of the pairs.
const Node* sequence_of(const Node& application);

/// Says how tightly a node binds, as it is printed.
int strength(const Node& node);

/// Says whether a relation stands in what is printed of a node, outside of brackets and of a quantifier's body: it
/// would end the body of a λ or μ.
bool shows_relation(const Node& node);

}  // namespace durero::zed
