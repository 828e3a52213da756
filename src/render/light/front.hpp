#pragma once
/// Of several elements at one point the first by name gives colour and normal.

#include <algorithm>

#include "durero/scene/scene.hpp"

namespace durero::render {

/// The element that gives a point its look: the first by name.
inline scene::ElementRef front(const scene::Scene& scene, const scene::ElementSet& elements) {
  if (elements.size() == 1) return elements[0];
  return *std::min_element(elements.begin(), elements.end(),
                           [&](auto a, auto b) { return scene.name(a) < scene.name(b); });
}

}  // namespace durero::render
