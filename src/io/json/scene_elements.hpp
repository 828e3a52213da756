#pragma once
/// The elements of a scene, in an order that depends on the scene alone and not on how it was edited.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "durero/scene/scene.hpp"

namespace durero::io {

/// Elements with their names, ascending by the bytes of these.
inline std::vector<scene::ElementRef> in_order(std::vector<std::pair<std::string, scene::ElementRef>> named) {
  std::ranges::sort(named);
  std::vector<scene::ElementRef> all;
  all.reserve(named.size());
  for (const auto& one : named) all.push_back(one.second);
  return all;
}

/// @{ Every element, and those by themselves, in no mesh. Ascending by the bytes of the names.
inline std::vector<scene::ElementRef> elements_by_name(const scene::Scene& scene) {
  std::vector<std::pair<std::string, scene::ElementRef>> named;
  scene.for_each([&](scene::ElementRef e, const auto&) { named.emplace_back(scene.name(e).name(), e); });
  return in_order(std::move(named));
}
inline std::vector<scene::ElementRef> singles_by_name(const scene::Scene& scene) {
  std::vector<std::pair<std::string, scene::ElementRef>> named;
  scene.for_each_single([&](scene::ElementRef e, const auto&) { named.emplace_back(scene.name(e).name(), e); });
  return in_order(std::move(named));
}
/// @}

}  // namespace durero::io
