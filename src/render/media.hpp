#pragma once
/// The media that a ray is in, one within the other.

#include <cstdint>
#include <string>

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
    const auto last = entered_.rfind(material);
    if (last == entered_.npos) return false;
    entered_.erase(last, 1);
    return true;
  }

 private:
  std::u32string entered_;  // their places; a few stand in the string itself, and no memory is asked for
};

}  // namespace durero::render
