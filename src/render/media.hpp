#pragma once
/// The media that a ray is in, one within the other.

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <iterator>

#include "durero/scene/stage.hpp"

namespace durero::render {

/// The materials that a ray has entered and not left, the last one last. Empty: the open.
class Media {
 public:
  /// The index of the innermost, which is that of `stage`; 1 in the open.
  double index(const scene::Stage& stage) const {
    return entered_.empty() ? 1 : stage.materials[entered_.back()].index;
  }
  /// Into a material.
  void enter(std::uint32_t material) { entered_.push_back(material); }
  /// Out of the last of that material. Whether there was one.
  bool leave(std::uint32_t material) {
    const auto last = std::find(entered_.rbegin(), entered_.rend(), material);
    if (last == entered_.rend()) return false;
    entered_.erase(std::next(last).base());
    return true;
  }

 private:
  boost::container::small_vector<std::uint32_t, 4> entered_;  // mostly so few, and so no memory is asked for
};

}  // namespace durero::render
