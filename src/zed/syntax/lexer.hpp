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
/// The tokens point into the operators, which must outlive them.
std::vector<Token> lex_latex(const Block& block, const Markup& markup, const Operators& operators);

/// Returns the tokens of an expression in Unicode, as one types it on a command line, or of a paragraph. A line end
/// gives `newline` by the same rule; the lines of a box are blanks, but for ├, which gives `|`. `0.25` is one numeral,
/// and a name between quotation marks is a word that keeps them. `.. `, `−`, `⦁`, `′` and `\` are read as `‥`, `-`,
/// `•`, `'` and `∖`. What cannot be read gives a last token of type `error`.
std::vector<Token> lex_unicode(std::string_view text, const Operators& operators, Place place = {1, 1});

/// Returns the tokens of a formal paragraph in its mark-up.
std::vector<Token> lex(const Block& block, const Markup& markup, const Operators& operators);

}  // namespace durero::zed
