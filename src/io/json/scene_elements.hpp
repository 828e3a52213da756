#pragma once
/// The elements of a scene, in an order that depends on the scene alone and not on how it was edited.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "durero/scene/scene.hpp"

namespace durero::io {

/// The elements that walk(take) hands to take(element, shape), ascending by the bytes of their names.
template <class Walk>
std::vector<scene::ElementRef> by_name(const scene::Scene& scene, Walk&& walk) {
  std::vector<std::pair<std::string, scene::ElementRef>> named;
  walk([&](scene::ElementRef e, const auto&) { named.emplace_back(scene.name(e).name(), e); });
  std::ranges::sort(named);
  std::vector<scene::ElementRef> all;
  all.reserve(named.size());
  for (const auto& one : named) all.push_back(one.second);
  return all;
}

/// @{ Every element, and those by themselves, in no mesh. Ascending by the bytes of the names.
inline std::vector<scene::ElementRef> elements_by_name(const scene::Scene& scene) {
  return by_name(scene, [&](const auto& take) { scene.for_each(take); });
}
inline std::vector<scene::ElementRef> singles_by_name(const scene::Scene& scene) {
  return by_name(scene, [&](const auto& take) { scene.for_each_single(take); });
}
/// @}

}  // namespace durero::io
