#pragma once
/// Looks of one kind alone, which stand for materials of other programs.

#include <glm/vec3.hpp>

#include "durero/scene/stage.hpp"

namespace durero::io {

/// A mirror of that colour.
inline scene::Material mirror_of(const glm::dvec3& color) { return {.k_d = 0, .k_ps = 1, .M_PS = color}; }

/// Glass of that colour; with the index 1, a pane that turns no ray.
inline scene::Material glass_of(const glm::dvec3& color, double index = 1) {
  return {.k_d = 0, .k_t = 1, .M_T = color, .index = index};
}

}  // namespace durero::io
