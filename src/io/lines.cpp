#include "durero/io/lines.hpp"

#include <algorithm>

namespace durero::io {

std::optional<TextLine> Lines::next() noexcept {
  if (next_ >= text_.size()) return std::nullopt;
  const std::size_t begin = next_;
  const std::size_t end = std::min(text_.find_first_of("\r\n", begin), text_.size());
  next_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
  return TextLine{++number_, begin, end};
}

/// Between two line ends among the bytes there are too few of them for a line that is too long, so the first alone and
/// what is behind the last are looked at.
std::optional<std::size_t> LineLengths::pass(std::string_view bytes) noexcept {
  constexpr std::string_view ends = "\r\n";
  const std::size_t before = count_;
  count_ += bytes.size();
  const std::size_t first = std::min(bytes.find_first_of(ends), bytes.size());
  if (before + first - begin_ > longest_) return begin_ + longest_;
  if (first < bytes.size()) begin_ = before + bytes.find_last_of(ends) + 1;
  return std::nullopt;
}

std::size_t count_lines(std::string_view text) noexcept {
  std::size_t count = 0;
  for (Lines lines(text); lines.next();) ++count;
  return count;
}

}  // namespace durero::io
