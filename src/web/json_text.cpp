#include "json_text.hpp"

#include <algorithm>

namespace durero::web {

std::string array_of_lines(std::string_view lines, bool quoted) {
  ArrayText array;
  while (!lines.empty()) {
    const std::string_view line = lines.substr(0, lines.find('\n'));
    array.raw(quoted ? json_of(line) : std::string(line));
    lines.remove_prefix(std::min(line.size() + 1, lines.size()));
  }
  return array.text();
}

}  // namespace durero::web
