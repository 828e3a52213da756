#pragma once
/// Writes one paragraph in another mark-up.

#include <string>
#include <vector>

#include "durero/zed/print/convert.hpp"
#include "zed/print/pieces.hpp"
#include "zed/print/spivey_grammar.hpp"
#include "zed/syntax/source.hpp"
#include "zed/syntax/token.hpp"

namespace durero::zed {

/// Returns how many of a paragraph's tokens stand on the line that begins its box: a schema's name, and formals.
std::size_t in_title(const Block& block, const std::vector<Token>& tokens);

/// Returns a piece from its first sign or `\begin` to its last or `\end`. Mark-up that cannot say it is written as if
/// it could: whoever calls reads it again. `known` has the schemas, which Spivey's Z writes otherwise. Throws ZError at
/// a name that Spivey's Z cannot spell. Where it is `regrouped`, operands of Spivey's Z stand in parentheses that ISO's
/// would take for others, and `x \inrel{R} y` is (x, y) ∈ R.
std::string in_other_form(const BlockPiece& piece, Form to, const Dialect& dialect, const SchemaNames& known,
                          bool regrouped = false);

}  // namespace durero::zed
