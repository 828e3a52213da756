#pragma once
/// The layout of paragraphs in LaTeX mark-up: that of spec/.

#include <string_view>
#include <vector>

#include "durero/zed/names/rename.hpp"
#include "durero/zed/syntax/reader.hpp"

namespace durero::zed {

/// A line of spec/ has no more columns.
inline constexpr std::size_t most_columns = 100;

/// Returns what gives the paragraphs of a LaTeX text the layout of spec/: each as it comes back from Unicode mark-up
/// (convert.hpp), with the same tokens, labels, comments and tree: its line ends and indents are those that `\\`,
/// `\also` and `\t1` make, and blanks within a line stay. A paragraph that would have a line of more than
/// `most_columns` is left as it is, and so is a text in Unicode, of which the layout is its own. `read` is what reading
/// found in the file. Precondition: the text was read without a defect. Throws ZError at what Unicode cannot say.
std::vector<Replacement> block_layout(std::string_view text, const Specification& read);

}  // namespace durero::zed
