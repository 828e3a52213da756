#pragma once
/// The pieces of a `zed` block: its lines, cut where they become paragraphs of different kinds in another mark-up.

#include <vector>

#include "durero/zed/syntax/ast.hpp"
#include "durero/zed/syntax/markup.hpp"
#include "durero/zed/syntax/operators.hpp"
#include "zed/syntax/source.hpp"

namespace durero::zed {

/// The tokens of a section are read by its commands and its operators.
struct Dialect {
  const Markup& markup;
  const Operators& operators;
};

/// A share of a block is a run of its lines of one kind.
enum class Share : unsigned char {
  plain,       ///< definitions, given and free types; or a whole box
  operators,   ///< one operator template
  claim,       ///< one conjecture
  constraint,  ///< one predicate by itself, as only Spivey's Z has
};

/// A piece is a block in the same text, with the paragraphs that it has.
struct BlockPiece {
  Block block;
  Share share = Share::plain;
  std::vector<Paragraph> paragraphs{};  ///< a template is none
};

/// Returns the pieces of a block in their order; of a box, one. Throws ZError where it cannot be parsed.
std::vector<BlockPiece> pieces_of(const Block& block, const Dialect& dialect);

}  // namespace durero::zed
