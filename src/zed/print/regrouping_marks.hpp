#pragma once
/// The signs that ISO's Z needs around tokens of Spivey's Z.

#include <vector>

#include "zed/print/spelling.hpp"
#include "zed/print/spivey_tokens.hpp"
#include "zed/syntax/regrouping.hpp"
#include "zed/syntax/token.hpp"

namespace durero::zed {

/// Returns the signs, by tokens counted without line ends: parentheses around operands, and (x, y) ∈ R for a membership
/// in a named relation, whose name is not written where it stood.
SpiveyMarks regrouping_marks(const std::vector<Token>& tokens, const IsoGrouping& regrouping, const Spelling& spelling,
                             bool latex);

}  // namespace durero::zed
