#pragma once
/// Random syntax trees: every tree that the parser can make, and no other.

#include <rapidcheck.h>

#include "durero/zed/syntax/ast.hpp"

namespace durero::zed::test {

/// `size` bounds the number of nodes.
rc::Gen<Term> expression(int size);  ///< an expression or a predicate
rc::Gen<Paragraph> paragraph(int size);

}  // namespace durero::zed::test
