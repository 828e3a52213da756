#pragma once
/// How the printer sees a node: by which operator it is printed, and how tightly that binds.

#include <string_view>

#include "durero/zed/syntax/ast.hpp"
#include "zed/syntax/symbols.hpp"

namespace durero::zed {

/// The operator that an application or a reference is printed with, or null where it is printed as such.
const Operator* operator_of(const Node& node);
int operator_strength(const Operator& op);

/// f ⦇ S ⦈
bool is_image(const Node& node);

/// The sequence that an application of ⟨,,⟩ stands for, or null: the elements are the second parts of the pairs.
const Node* sequence_of(const Node& application);

/// How tightly a node binds, as it is printed.
int strength(const Node& node);

}  // namespace durero::zed
