#pragma once
/// Which faces of a mesh belong together, by the names that its file gives them.

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace durero::io {

struct FaceGroups {
  using Number = std::uint32_t;  ///< of a group, in the order in which they are named first
  static constexpr Number none = std::numeric_limits<Number>::max();

  std::map<std::string, Number, std::less<>> numbers;  ///< of each name
  std::vector<Number> within;   ///< of each group the one that it lies in, which has a smaller number; or none
  std::vector<Number> of_face;  ///< none of a face that is in no group; of no face where empty

  /// The group of that name. Where there is none it is made, and lies in the other that is named, or in none.
  Number group(std::string_view name, Number in = none) {
    const auto [place, is_new] = numbers.try_emplace(std::string(name), static_cast<Number>(numbers.size()));
    if (is_new) within.push_back(in);
    return place->second;
  }
};

}  // namespace durero::io
