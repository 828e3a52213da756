#pragma once
/// The cutters of the two mark-ups share what is here.

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "durero/text/utf8.hpp"
#include "zed/syntax/source.hpp"

namespace durero::zed {

/// Walks over a text and knows its place.
struct Cursor {
  std::string_view text;
  std::size_t at = 0;
  Place place{1, 1};

  bool done() const { return at >= text.size(); }
  /// Says whether this stands here. Precondition: it is not empty.
  bool sees(std::string_view what) const {
    return !done() && text[at] == what.front() && text.substr(at, what.size()) == what;
  }
  void step() {
    if (text[at] == '\n') {
      ++place.line;
      place.column = 0;
    }
    ++at;
    while (!done() && text::continues(text[at])) ++at;
    ++place.column;
  }
  void skip(std::size_t bytes) {
    for (const std::size_t end = std::min(at + bytes, text.size()); at < end;) step();
  }
  std::string_view rest_of_line() const { return text.substr(at, text.find('\n', at) - at); }
};

/// Reads the directive on the line that begins here, if one does.
void take_directive(const Cursor& at, const std::string& file, Markup& into, std::vector<Defect>& defects);

/// Says whether a line of a text begins a box of Unicode.
bool has_box(std::string_view text);

/// Cuts a text in Unicode mark-up (ISO/IEC 13568, 8.2, and the boxes of to_unicode()): a paragraph begins with a line
/// that begins with ─ (what \begin{zed} is in LaTeX), ╷ or ┌ alone (axdef), ═ or ┌ [ (gendef) or ┌ NAME (schema), and
/// ends at a line that begins with └.
std::vector<Block> cut_unicode(std::string_view text, const std::string& file, std::vector<Defect>& defects);

}  // namespace durero::zed
