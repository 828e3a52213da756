#pragma once
/// What a change of format loses: a line for each kind of thing, with its number.

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

namespace durero::io {

/// Adds `N things fate`, where n > 0.
inline void add_loss(std::vector<std::string>& lost, std::size_t n, std::string_view one, std::string_view many,
                     std::string_view fate) {
  if (n > 0) lost.push_back(fmt::format("{} {} {}", n, n == 1 ? one : many, fate));
}

}  // namespace durero::io
