#pragma once
/// Every element of a scene, in an order that depends on the scene alone and not on how it was edited.

#include <algorithm>
#include <string_view>
#include <vector>

#include "durero/scene/scene.hpp"

namespace durero::io {

/// Ascending by the bytes of the names.
inline std::vector<scene::ElementRef> elements_by_name(const scene::Scene& scene) {
  std::vector<scene::ElementRef> all;
  all.reserve(scene.size());
  scene.for_each([&](scene::ElementRef element, const auto&) { all.push_back(element); });
  const auto name = [&](scene::ElementRef element) -> std::string_view { return scene.name(element).name(); };
  std::ranges::sort(all, {}, name);
  return all;
}

}  // namespace durero::io
