#pragma once
/// The elements of a scene, in an order that depends on the scene alone and not on how it was edited.

#include <vector>

#include "durero/scene/scene.hpp"

namespace durero::scene {

/// @{ Every element, and those by themselves, in no mesh. Ascending by the bytes of the names.
std::vector<ElementRef> elements_by_name(const Scene& scene);
std::vector<ElementRef> singles_by_name(const Scene& scene);
/// @}

}  // namespace durero::scene
