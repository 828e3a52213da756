#pragma once
/// Terms in messages.

#include <string>

#include "durero/zed/syntax/ast.hpp"

namespace durero::zed {

/// The term in Unicode.
std::string describe(const Node& node);

}  // namespace durero::zed
