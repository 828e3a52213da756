#pragma once
/// Splits characters into tokens, from either mark-up.

#include <string_view>
#include <vector>

#include "zed/syntax/source.hpp"
#include "zed/syntax/token.hpp"

namespace durero::zed {

/// Returns the tokens of a formal paragraph in LaTeX mark-up, the last of type `end`. `\where` gives the symbol `|`;
/// `\\` and `\also` give `newline`, but where the text goes on across it (ISO/IEC 13568, 7.5: beside an infix operator,
/// after a prefix one, before a closing bracket). What cannot be read gives a last token of type `error`.
std::vector<Token> lex_latex(const Block& block, const Markup& markup);

/// Returns the tokens of an expression in Unicode, as one types it on a command line. A line end gives `newline` by the
/// same rule. `0.25` is one numeral, and a name between quotation marks is a word that keeps them. `.. `, `−`, `⦁`, `′`
/// and `\` are read as `‥`, `-`, `•`, `'` and `∖`. What cannot be read gives a last token of type `error`.
std::vector<Token> lex_unicode(std::string_view text);

}  // namespace durero::zed
