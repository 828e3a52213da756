#pragma once
/// The words of questions, and the words of any line, separated by blanks.

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "durero/conform/ask/profile.hpp"

namespace durero::conform {

/// The words before the number of rays, by the question about them.
inline constexpr std::array<std::string_view, question_words.size()> heads_of_rays = {
    "rays", "shadows", "ranges", "crossings", "counts", "points", "casts"};

inline std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\v\f";
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(blanks); begin != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(blanks, end);
  }
  return words;
}

}  // namespace durero::conform
