#pragma once
/// The media that a ray is in are nested, one within the other.

#include <compare>
#include <cstdint>
#include <string>

#include "durero/scene/stage.hpp"

namespace durero::render {

/// The materials that a ray has entered and not left, the last one last. Without any the ray is in the open.
class Media {
 public:
  /// The refractive index of the innermost medium, by the materials of `stage`; 1 in the open.
  double index(const scene::Stage& stage) const {
    return entered_.empty() ? 1 : stage.materials[entered_.back()].index;
  }
  /// Enters a material.
  void enter(std::uint32_t material) { entered_.push_back(material); }
  /// Leaves the last entered medium of that material. Returns whether there was one.
  bool leave(std::uint32_t material) {
    const auto last = entered_.rfind(material);
    if (last == entered_.npos) return false;
    entered_.erase(last, 1);
    return true;
  }
  /// Crosses a surface of that material, from its outer side or from within. Returns the index before it over that
  /// beyond. A ray that leaves a material without having entered it was in it.
  double cross(bool enters, std::uint32_t material, const scene::Stage& stage) {
    const double here = index(stage);
    const bool was_in = enters || leave(material);
    if (enters) enter(material);
    return (was_in ? here : stage.materials[material].index) / index(stage);
  }
  auto operator<=>(const Media&) const = default;

 private:
  std::u32string entered_;  // their numbers; the string holds a few in itself, without an allocation
};

}  // namespace durero::render
