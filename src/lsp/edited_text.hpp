#pragma once
/// A text that an editor edits, with the editor's positions in it.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "durero/zed/syntax/ast.hpp"

namespace durero::lsp {

/// The unit of a position's character: what a client and this server agreed on.
enum class PositionUnit : std::uint8_t { utf8, utf16, utf32 };

/// A position counts lines, and units in its line, from 0.
struct EditorPosition {
  std::uint32_t line = 0, character = 0;
  auto operator<=>(const EditorPosition&) const = default;
};

/// A text in UTF-8. Where an edit in units of UTF-16 parts a character in two, its halves are kept as three bytes each
/// until they meet again, so that the text is the editor's at any time: a lone half is no character of Z, and is
/// reported as one.
class EditedText {
 public:
  explicit EditedText(std::string text = {}, PositionUnit unit = PositionUnit::utf16);

  const std::string& text() const { return text_; }
  /// Returns the byte of a position. A line or character beyond the end is the end, as the protocol says, and a
  /// position within a character is where that begins.
  std::size_t byte_of(EditorPosition position) const;
  EditorPosition position_of(std::size_t byte) const;
  /// Returns the byte of a place, whose lines end at line feeds alone.
  std::size_t byte_of(zed::Place place) const;

  /// Puts a text in the place of what stands between two positions, of which the first is not behind the second.
  void edit(EditorPosition from, EditorPosition to, std::string_view now);

 private:
  void index();
  std::string_view line_at(std::size_t line) const;
  std::size_t units_of(std::string_view character) const;
  /// Makes a position within a character of four bytes one between two halves, and returns its byte.
  std::size_t part(EditorPosition position);
  void join(std::size_t byte);

  std::string text_;
  PositionUnit unit_;
  std::vector<std::size_t> lines_;    // the first byte of each; a line ends at \n, \r\n or \r
  std::vector<std::size_t> z_lines_;  // and so of the lines that places count
};

}  // namespace durero::lsp
