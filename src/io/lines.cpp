#include "durero/io/lines.hpp"

#include <algorithm>

namespace durero::io {

std::optional<Line> Lines::next() noexcept {
  if (next_ >= text_.size()) return std::nullopt;
  const std::size_t begin = next_;
  const std::size_t end = std::min(text_.find_first_of("\r\n", begin), text_.size());
  next_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
  return Line{++number_, begin, end};
}

std::size_t count_lines(std::string_view text) noexcept {
  std::size_t count = 0;
  for (Lines lines(text); lines.next();) ++count;
  return count;
}

}  // namespace durero::io
