#pragma once
/// Tokens to syntax trees (ISO/IEC 13568, clause 8).

#include <string_view>
#include <vector>

#include "durero/zed/ast.hpp"
#include "durero/zed/lexer.hpp"

namespace durero::zed {

/// How deep an expression may nest, and a tree may be: deeper is an error that says so. A chain of n operators makes
/// a tree n deep, and the deepest predicate of spec/ is some 20 deep, so 500 is ample. It keeps the stack small: every
/// recursion over a tree of this depth, whatever it is made of, fits 3 MB under AddressSanitizer, the costliest build
/// (measured with the nests of tests/zed/fuzz_test.cpp), of the 8 MB that a thread has.
inline constexpr unsigned max_depth = 500;

/// The header `\SECTION name \parents a, b`.
struct SectionHeader {
  std::string name;
  std::vector<std::string> parents;
};

SectionHeader parse_header(const std::vector<Token>& tokens);  ///< throws ZError

/// The paragraphs of one block (several, in `zed`). Throws ZError where it cannot go on; an error behind which it can
/// is added to `mended`: a set behind `::=` is read as if behind `==`.
std::vector<Paragraph> parse_block(std::string_view environment, const std::vector<Token>& tokens,
                                   std::vector<ZError>& mended);

/// The names that a block which cannot be parsed would declare, as far as its tokens tell.
std::vector<Name> names_declared(std::string_view environment, const std::vector<Token>& tokens);

/// One expression or predicate in Unicode, to the end of the text. Throws ZError.
Term parse_unicode(std::string_view text);

/// One paragraph in Unicode, in the form that to_unicode() prints. Throws ZError.
Paragraph parse_unicode_paragraph(std::string_view text);

/// One expression or predicate in LaTeX mark-up, to the end of the text. Throws ZError.
Term parse_latex(std::string_view text, const Markup& markup = {});

}  // namespace durero::zed
