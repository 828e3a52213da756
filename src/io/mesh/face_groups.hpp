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
  std::vector<Number> of_face;                         ///< none of a face that is in no group; of no face where empty

  /// The group of that name, which is made where there is none.
  Number group(std::string_view name) {
    return numbers.try_emplace(std::string(name), static_cast<Number>(numbers.size())).first->second;
  }
};

}  // namespace durero::io
