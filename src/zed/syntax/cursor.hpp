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
class Cursor {
 public:
  explicit Cursor(std::string_view over, Place first = {1, 1}) : text(over), place_(first) {}

  std::string_view text;
  std::size_t at = 0;

  bool done() const { return at >= text.size(); }
  /// Says whether this stands here. Precondition: it is not empty.
  bool sees(std::string_view what) const {
    return !done() && text[at] == what.front() && text.substr(at, what.size()) == what;
  }
  void step() { skip(1); }
  /// Goes on by so many bytes, to the end of the character that the last of them is in.
  void skip(std::size_t bytes) {
    at = std::min(at + bytes, text.size());
    while (!done() && text::continues(text[at])) ++at;
  }
  /// Goes on to the next character that is one of some in ASCII, or to the end.
  template <class IsOne>
  void skip_to(IsOne&& is_one) {
    const std::string_view rest = text.substr(at);
    at += static_cast<std::size_t>(std::ranges::find_if(rest, is_one) - rest.begin());
  }
  std::string_view rest_of_line() const { return text.substr(at, text.find('\n', at) - at); }

  /// Returns the place here, which it counts on from where it was asked for last.
  Place place() {
    std::string_view over = text.substr(counted_, at - counted_);
    counted_ = at;
    if (const std::size_t newline = over.rfind('\n'); newline != over.npos) {
      place_ = {place_.line + static_cast<std::uint32_t>(std::ranges::count(over, '\n')), 1};
      over.remove_prefix(newline + 1);
    }
    const auto continuing = static_cast<std::size_t>(std::ranges::count_if(over, text::continues));
    place_.column += static_cast<std::uint32_t>(over.size() - continuing);
    return place_;
  }

 private:
  std::size_t counted_ = 0;
  Place place_;
};

/// Reads the directive on the line that begins here, if one does.
void take_directive(Cursor& at, const std::string& file, Markup& into, std::vector<Defect>& defects);

/// Says whether a line of a text begins a box of Unicode.
bool has_box(std::string_view text);

/// Cuts a text in Unicode mark-up (ISO/IEC 13568, 8.2, and the boxes of to_unicode()): a paragraph begins with a line
/// that begins with ─ (what \begin{zed} is in LaTeX), ╷ or ┌ alone (axdef), ═ or ┌ [ (gendef) or ┌ NAME (schema), and
/// ends at a line that begins with └.
std::vector<Block> cut_unicode(std::string_view text, const std::string& file, std::vector<Defect>& defects);

}  // namespace durero::zed
