#pragma once
/// The blocks of a file with their tokens, as the reader saw them.

#include <string>
#include <string_view>
#include <vector>

#include "durero/zed/syntax/reader.hpp"
#include "zed/syntax/source.hpp"
#include "zed/syntax/token.hpp"

namespace durero::zed {

/// A block, whose tokens point into the operators of what was read.
struct TokenizedBlock {
  Block block;
  std::string section;     ///< it stands in this section
  std::size_t offset = 0;  ///< its body begins at this byte of the file
  std::vector<Token> tokens;

  bool is_header() const { return block.environment == "zsection"; }
  std::size_t begin_of(const Token& token) const { return offset + token.from; }
  std::size_t end_of(const Token& token) const { return offset + token.to; }
  /// Says whether a place is in its body.
  bool holds(Place place) const;
};

/// Returns the blocks of a text, which must outlive them, as what was read is to.
std::vector<TokenizedBlock> tokenized(std::string_view text, const Specification& read);

}  // namespace durero::zed
