#pragma once
/// Prints syntax trees in either mark-up, with no parentheses but those that reading back needs: parsing what is
/// printed gives the tree again, for every tree that the parser can make.

#include <string>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/syntax/markup.hpp"

namespace durero::zed {

/// Prints a term on one line: `∀ e : elementos • e ∈ dom mi_centro`.
std::string to_unicode(const Term& term);

/// Prints a paragraph, and draws a box of several lines where it is one. A label stands behind `%` at the end of its
/// line.
std::string to_unicode(const Paragraph& paragraph);

/// Prints with the commands of `markup`, which are those of the directives that name characters beyond the toolkit's,
/// such as ℝ. A character without a command is printed as it is.
std::string to_latex(const Term& term, const Markup& markup = {});
/// Prints a paragraph as an environment (`zed`, `axdef`, `gendef`, `schema`), which ends in a line end.
std::string to_latex(const Paragraph& paragraph, const Markup& markup = {});

}  // namespace durero::zed
