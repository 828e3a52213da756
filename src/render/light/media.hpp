#pragma once
/// The media that a ray is in are nested, one within the other.

#include <cstdint>
#include <map>
#include <memory>

#include "durero/scene/stage.hpp"

namespace durero::render {

/// The materials that a ray has entered and not left, the last one last. Without any the ray is in the open. It is as
/// small as a pointer, since each path carries one: the nestings that a thread has met stand in a tree, once each, as
/// long as the thread lives, and no other thread may use them.
class Media {
 public:
  /// The refractive index of the innermost medium, by the materials of `stage`; 1 in the open.
  double index(const scene::Stage& stage) const {
    return innermost_ == nullptr ? 1 : stage.materials[innermost_->material].index;
  }
  /// Enters a material.
  void enter(std::uint32_t material) { innermost_ = within(innermost_, material); }
  /// Leaves the last entered medium of that material. Returns whether there was one.
  bool leave(std::uint32_t material) {
    const Nesting* last = innermost_;
    while (last != nullptr && last->material != material) last = last->around;
    if (last == nullptr) return false;
    innermost_ = without(innermost_, *last);
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

 private:
  /// A medium within others.
  struct Nesting {
    const Nesting* around = nullptr;  ///< null in the open
    std::uint32_t material = 0;
    std::map<std::uint32_t, std::unique_ptr<Nesting>> inner{};  ///< by material
  };

  /// A material within those; null is the open.
  static const Nesting* within(const Nesting* around, std::uint32_t material) {
    thread_local Nesting open;
    // Of this thread's own tree, which const protects from paths alone.
    auto& inner = around == nullptr ? open.inner : const_cast<Nesting*>(around)->inner;
    std::unique_ptr<Nesting>& one = inner[material];
    if (!one) one = std::make_unique<Nesting>(Nesting{around, material});
    return one.get();
  }
  /// Those media without one of them.
  static const Nesting* without(const Nesting* media, const Nesting& one) {
    return media == &one ? one.around : within(without(media->around, one), media->material);
  }

  const Nesting* innermost_ = nullptr;
};

}  // namespace durero::render
