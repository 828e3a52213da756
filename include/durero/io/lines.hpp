#pragma once
/// The lines of a text. A line ends at "\n", at "\r\n" or at "\r" alone, whichever system wrote the text, and readers
/// and places go by this one rule.

#include <cstddef>
#include <optional>
#include <string_view>

namespace durero::io {

/// A line: its number, from 1, and its bytes [begin, end) in the text, without its end.
struct TextLine {
  std::size_t number;  ///< from 1
  std::size_t begin;   ///< its first byte
  std::size_t end;     ///< behind its last byte: where its line end stands, or the text ends
  bool operator==(const TextLine&) const = default;
};

/// Walks the lines of a text, which must outlive it.
class Lines {
 public:
  /// Stands before the first line.
  explicit Lines(std::string_view text) noexcept : text_(text) {}

  /// The next line; nothing behind the last. What stands behind the last line end is a line where it is not empty.
  std::optional<TextLine> next() noexcept;

 private:
  std::string_view text_;
  std::size_t next_ = 0;
  std::size_t number_ = 0;
};

/// True where a line ends behind that byte of the text: "\r\n" ends one line, behind its "\n".
constexpr bool ends_line(std::string_view text, std::size_t at) noexcept {
  return text[at] == '\n' || (text[at] == '\r' && text.substr(at + 1, 1) != "\n");
}

/// How many bytes a line has at most, without its end. The longest that means something names elements: a ray has six
/// numbers, which no one has to write with more than 1077 characters (of the least binary64 in full a sign, "0." and
/// 1074 digits), and " @name" of up to 130 bytes for each element that it starts on; a hit and an operation take up to
/// 131 bytes a name. A corner of an OBJ face takes 63. So there is room for 128 000 of the longest names on a line.
inline constexpr std::size_t longest_line = std::size_t{1} << 24U;

/// Watches how long lines grow while their bytes come.
class LineLengths {
 public:
  /// Of lines that have at most so many bytes.
  explicit LineLengths(std::size_t longest = longest_line) noexcept : longest_(longest) {}

  /// The bytes behind those of before, at most as many as a line may have. Where a line has become too long: which
  /// byte, of all that came, is the first too many.
  std::optional<std::size_t> pass(std::string_view bytes) noexcept;

 private:
  std::size_t longest_;
  std::size_t begin_ = 0;  // of the line that has not ended
  std::size_t count_ = 0;
};

/// How many lines a text has.
std::size_t count_lines(std::string_view text) noexcept;

}  // namespace durero::io
