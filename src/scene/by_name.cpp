#include "durero/scene/by_name.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace durero::scene {
namespace {

/// The elements that walk(take) hands to take(element, shape). Names are made once each: those of faces are values.
template <class Walk>
std::vector<ElementRef> by_name(const Scene& scene, Walk&& walk) {
  std::vector<std::pair<std::string, ElementRef>> named;
  walk([&](ElementRef e, const auto&) { named.emplace_back(scene.name(e).name(), e); });
  std::ranges::sort(named);
  std::vector<ElementRef> all;
  all.reserve(named.size());
  for (const auto& one : named) all.push_back(one.second);
  return all;
}

}  // namespace

std::vector<ElementRef> elements_by_name(const Scene& scene) {
  return by_name(scene, [&](const auto& take) { scene.for_each(take); });
}

std::vector<ElementRef> singles_by_name(const Scene& scene) {
  return by_name(scene, [&](const auto& take) { scene.for_each_single(take); });
}

}  // namespace durero::scene
