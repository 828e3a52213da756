#include "prose.hpp"

#include <algorithm>

namespace durero::web {

std::vector<std::string_view> pieces_of(std::string_view text, char separator) {
  std::vector<std::string_view> pieces;
  while (!text.empty()) {
    pieces.push_back(text.substr(0, text.find(separator)));
    text.remove_prefix(std::min(pieces.back().size() + 1, text.size()));
  }
  return pieces;
}

std::vector<Prose> prose_of(std::string_view text) {
  std::vector<Prose> all;
  bool inside = false, open = false;  // an environment, a block
  std::uint32_t number = 0;
  for (const std::string_view line : pieces_of(text, '\n')) {
    ++number;
    const bool begins = line.starts_with("\\begin{");
    if (inside || begins || line.empty() || line.starts_with('%')) {
      inside = (inside || begins) && !line.starts_with("\\end{");
      open = false;
      continue;
    }
    if (!open) all.push_back({number, ""});
    all.back().text.append(open ? "\n" : "").append(line);
    open = true;
  }
  return all;
}

}  // namespace durero::web
