#pragma once
/// Names terms in messages.

#include <string>

#include "durero/zed/syntax/ast.hpp"

namespace durero::zed {

/// Writes the term in Unicode; the set of one schema's bindings is named by the schema.
std::string describe(const Node& node);

}  // namespace durero::zed
