#pragma once
/// Parses the tokens of a block to its paragraphs; the terms in them are parsed by term_parser.hpp.

#include <string>
#include <string_view>
#include <vector>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/syntax/defect.hpp"
#include "durero/zed/syntax/operators.hpp"
#include "zed/syntax/regrouping.hpp"
#include "zed/syntax/token.hpp"

namespace durero::zed {

/// The header of a section is `\SECTION name \parents a, b`.
struct SectionHeader {
  std::string name;
  std::vector<std::string> parents;
};

SectionHeader parse_header(const std::vector<Token>& tokens);  ///< throws ZError

/// Parses the paragraphs of one block (several, in `zed`). Throws ZError where it cannot go on; an error behind which
/// it can is added to `mended`: a set behind `::=` is read as if behind `==`. In Spivey's Z operators bind
/// as there, and a `zed` block may have predicates of their own, constraints on what is declared already; they become
/// boxes without declarations.
std::vector<Paragraph> parse_block(std::string_view environment, const std::vector<Token>& tokens,
                                   std::vector<ZError>& mended, bool spivey = false);

/// Returns what ISO's Z would take for another tree in the tokens of a block of Spivey's Z. Throws ZError as
/// parse_block() does.
IsoGrouping regrouping_of(std::string_view environment, const std::vector<Token>& tokens);

/// An operator template was read at a place.
struct ReadTemplate {
  OperatorTemplate read;
  Place place;
  std::vector<Token> tokens;  ///< it was read from these
};

/// Returns the templates in the tokens of a `zed` block, which its section needs to be read. One that cannot be
/// read is left to parse_block().
std::vector<ReadTemplate> templates_in(const std::vector<Token>& tokens);

/// Returns the names that a block which cannot be parsed would declare, as far as its tokens tell.
std::vector<Name> names_declared(std::string_view environment, const std::vector<Token>& tokens);

}  // namespace durero::zed
