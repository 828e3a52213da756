#pragma once
/// The lines of a text. A line ends at "\n", at "\r\n" or at "\r" alone, whichever system wrote the text, and readers
/// and places go by this one rule.

#include <cstddef>
#include <optional>
#include <string_view>

namespace durero::io {

/// A line: its number, from 1, and its bytes [begin, end) in the text, without its end.
struct Line {
  std::size_t number;  ///< from 1
  std::size_t begin;   ///< its first byte
  std::size_t end;     ///< behind its last byte: where its line end stands, or the text ends
  bool operator==(const Line&) const = default;
};

/// Walks the lines of a text, which must outlive it.
class Lines {
 public:
  /// Stands before the first line.
  explicit Lines(std::string_view text) noexcept : text_(text) {}

  /// The next line; nothing behind the last. What stands behind the last line end is a line where it is not empty.
  std::optional<Line> next() noexcept;

 private:
  std::string_view text_;
  std::size_t next_ = 0;
  std::size_t number_ = 0;
};

/// True where a line ends behind that byte of the text: "\r\n" ends one line, behind its "\n".
constexpr bool ends_line(std::string_view text, std::size_t at) noexcept {
  return text[at] == '\n' || (text[at] == '\r' && text.substr(at + 1, 1) != "\n");
}

/// How many lines a text has.
std::size_t count_lines(std::string_view text) noexcept;

}  // namespace durero::io
