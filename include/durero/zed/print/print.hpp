#pragma once
/// Syntax trees to text, in either mark-up, with no parentheses but those that reading back needs: parsing what is
/// printed gives the tree again, for every tree that the parser can make.

#include <string>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/syntax/markup.hpp"

namespace durero::zed {

/// One line: `∀ e : elementos • e ∈ dom mi_centro`.
std::string to_unicode(const Term& term);

/// A box of several lines where the paragraph is one; a label stands behind `%` at the end of its line.
std::string to_unicode(const Paragraph& paragraph);

/// `markup`: the directives that name characters beyond the toolkit's, such as ℝ; a character without a command is
/// printed as it is.
std::string to_latex(const Term& term, const Markup& markup = {});
std::string to_latex(const Paragraph& paragraph, const Markup& markup = {});

}  // namespace durero::zed
