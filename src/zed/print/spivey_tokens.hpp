#pragma once
/// The tokens of a piece as Spivey's LaTeX has them, where it is not as ISO's.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "durero/zed/syntax/markup.hpp"
#include "zed/print/pieces.hpp"
#include "zed/print/spivey_grammar.hpp"
#include "zed/syntax/token.hpp"

namespace durero::zed {

/// The signs of Spivey's Z around tokens, which are counted without line ends. A quantifier that is an operand stands
/// in parentheses; a line end inside of brackets is `;` or `\land`; a schema is defined by \defs.
struct SpiveyMarks {
  std::map<std::size_t, std::string> before, behind;  ///< they are written so
  std::map<std::size_t, std::string> instead;         ///< in the place of the token
};

/// Returns the signs of a piece, from its tokens with their line ends.
SpiveyMarks spivey_marks(const std::vector<Token>& tokens, const BlockPiece& piece, const SchemaNames& known);

/// Spells a token. Throws ZError at a name that Spivey's Z cannot spell.
std::string in_spivey(const Token& token, const Markup& markup);

/// Returns what stands between two tokens on a line that have so many blanks between them, by their spellings.
std::string gap_in_spivey(const Token& left, const std::string& left_text, const Token& right,
                          const std::string& right_text, std::size_t blanks);

}  // namespace durero::zed
