#pragma once
/// Writes one paragraph in the mark-up that it is not in.

#include <string>
#include <vector>

#include "durero/zed/syntax/markup.hpp"
#include "durero/zed/syntax/operators.hpp"
#include "zed/syntax/source.hpp"
#include "zed/syntax/token.hpp"

namespace durero::zed {

/// The tokens of a section are read by its commands and its operators.
struct Dialect {
  const Markup& markup;
  const Operators& operators;
};

/// Returns how many of a paragraph's tokens stand on the line that begins its box: a schema's name, and formals.
std::size_t in_title(const Block& block, const std::vector<Token>& tokens);

/// Returns the paragraph from its first sign or `\begin` to its last or `\end`. What the other mark-up cannot say is
/// written as it would be if it could: whoever calls reads it again.
std::string in_other_form(const Block& block, const Dialect& dialect);

}  // namespace durero::zed
