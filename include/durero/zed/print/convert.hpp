#pragma once
/// Conversion writes a Z text in the other mark-up: from LaTeX to Unicode, or back.

#include <string>
#include <string_view>

#include "durero/zed/syntax/reader.hpp"

namespace durero::zed {

/// The mark-ups that a text may be written in: the two of ISO/IEC 13568, and Spivey's LaTeX.
enum class Form : unsigned char { latex, unicode, spivey };

/// Returns the mark-up that a text is read in. One without a paragraph counts as ISO's LaTeX.
Form form_of(std::string_view text);

/// Returns the text in a mark-up; one that is in it already, as it is. `read` is what reading found in the file: its
/// directives and templates, and those of its parents. Each paragraph has the same tokens, labels and tree as before,
/// which is asked of what was written; in Spivey's Z, the same tree. Prose is kept byte for byte, but that a line end
/// stands before a box that began inside a line. Within a paragraph, comments and the lines that `\\`, `\also` and `\t`
/// make are kept; blanks at the beginning of a line and line ends that only TeX's sources have are not. So what is
/// written in Unicode is the same again after a way to LaTeX and back.
///
/// In ISO's mark-up the bags of Spivey's Z are a parent, its directives templates, and a predicate by itself an axdef.
/// In Spivey's Z a template is a directive, a conjecture a theorem, which fuzz passes over, and the header of the one
/// section a comment. Precondition: the text was read without a defect. Throws ZError at what the other mark-up cannot
/// say.
std::string converted(std::string_view text, Form to, const Specification& read);

}  // namespace durero::zed
