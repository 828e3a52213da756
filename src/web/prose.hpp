#pragma once
/// The prose between the paragraphs of a Z text.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace durero::web {

/// A block of prose.
struct Prose {
  std::uint32_t line;  ///< that it begins on, from 1
  std::string text;    ///< its lines, in the mark-up of LaTeX
};

/// The blocks of prose of a text, which blank lines and environments part. A line that is a comment alone is none.
std::vector<Prose> prose_of(std::string_view text);

/// The pieces of a text between separators; the last one need not have any behind it.
std::vector<std::string_view> pieces_of(std::string_view text, char separator);

}  // namespace durero::web
