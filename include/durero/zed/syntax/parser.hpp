#pragma once
/// Reads texts as syntax trees (ISO/IEC 13568, clause 8).

#include <string_view>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/syntax/markup.hpp"
#include "durero/zed/syntax/operators.hpp"

namespace durero::zed {

/// The greatest depth of nesting of an expression, and of a tree; deeper is an error that says so. A chain of n
/// operators makes a tree n deep, and the deepest predicate of spec/ is some 20 deep, so 500 is ample. It keeps the
/// stack small: every recursion over a tree of this depth, whatever its nodes, fits 3 MB under AddressSanitizer, the
/// costliest build (measured with the nests of tests/zed/fuzz_test.cpp), of the 8 MB that a thread has.
inline constexpr unsigned max_depth = 500;

/// Reads one expression or predicate in Unicode, to the end of the text, with the operators of templates in scope.
/// Throws ZError.
Term parse_unicode(std::string_view text, const Operators& operators = {});

/// Reads one paragraph in Unicode, in the form that to_unicode() prints. Throws ZError.
Paragraph parse_unicode_paragraph(std::string_view text, const Operators& operators = {});

/// Reads one expression or predicate in LaTeX mark-up, to the end of the text. Throws ZError.
Term parse_latex(std::string_view text, const Markup& markup = {}, const Operators& operators = {});

}  // namespace durero::zed
