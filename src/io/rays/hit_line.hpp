#pragma once
/// The line of a hit, and the names of its elements.

#include <cstddef>
#include <string>
#include <vector>

#include "durero/scene/hit.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// The names of a hit's elements, ascending by their bytes.
std::vector<std::string> names_of_hit(const scene::Hit& hit, const scene::Scene& scene);
/// Appends hit_text(ray, hit, scene).
void append_text(std::string& text, std::size_t ray, const scene::Hit& hit, const scene::Scene& scene);

}  // namespace durero::io
