#pragma once
/// A Z text in either mark-up is cut into its formal paragraphs; the prose between them is skipped.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/syntax/defect.hpp"
#include "durero/zed/syntax/markup.hpp"
#include "zed/syntax/spivey.hpp"

namespace durero::zed {

/// A block is a formal paragraph, as text: what stands between `\begin{environment}` and `\end{environment}`, or in a
/// box of Unicode.
struct Block {
  std::string environment;  ///< it is zsection, zed, axdef, gendef or schema; a theorem or syntax is as a zed
  std::string_view whole;   ///< from its sign or `\begin` to its last sign or `\end`, in the text given to cut()
  std::string_view body;    ///< what stands between
  Place begin;              ///< the `\begin` stands here
  Place place;              ///< the body begins here
  Place end;                ///< the `\end` stands here
  bool unicode = false;     ///< it is in Unicode mark-up, and the environment stands for its box
  Markup directives;        ///< they stand before this block and after the one before it
  std::shared_ptr<const SpiveyText> spivey;  ///< what is known of its text in Spivey's Z; null in ISO's
  std::vector<OperatorTemplate> operators;   ///< of fuzz's directives that stand where the directives do
};

/// Returns the places of braces in a block of LaTeX mark-up that only group, and may be meant for a set.
std::vector<Place> grouping_braces(const Block& block);

/// Says whether a text is in Unicode mark-up: it has a box, and no paragraph of LaTeX begins in it.
bool is_unicode(std::string_view text);

/// Cuts a text into blocks. `text` must outlive them. A defect, such as an environment that does not end, is added
/// to `defects`, and what can be cut is.
std::vector<Block> cut(std::string_view text, const std::string& file, std::vector<Defect>& defects);

}  // namespace durero::zed
