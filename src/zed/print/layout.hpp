#pragma once
/// What stands between two tokens, apart from the mark-up that says it: blanks, line ends and comments.

#include <string>
#include <string_view>
#include <vector>

namespace durero::zed {

/// A line of a paragraph, but for its tokens.
struct LayoutLine {
  std::size_t blanks = 0;  ///< they stand behind the last token on it, or before the first
  std::size_t indent = 0;  ///< so many steps of two blanks stand before its first token
  std::string comment;     ///< it ends the line, from its % on
};

/// Between two tokens stand the rest of one's line, lines without a token, and the beginning of the other's: one line
/// where both stand on the same. A line between that has no comment is the space that \also makes.
using Layout = std::vector<LayoutLine>;

/// Returns what LaTeX says between two tokens. A line end there is no more than a blank, but behind a comment.
Layout layout_of_latex(std::string_view text);

/// Returns what Unicode says between two tokens; the signs that draw a box are blanks.
Layout layout_of_unicode(std::string_view text);

/// A line break that the form of a paragraph asks for is not marked as one: those beside \begin, \where and \end.
enum class Break : bool { marked, formal };

std::string in_latex(const Layout& layout, Break kind);
std::string in_unicode(const Layout& layout);

}  // namespace durero::zed
