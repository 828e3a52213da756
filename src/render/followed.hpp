#pragma once
/// What all rays of a picture have in common.

#include <glm/vec3.hpp>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/render/whitted.hpp"
#include "looks.hpp"

namespace durero::render {

/// Made ready once, of a scene and an engine that outlive it unedited.
struct Followed {
  /// Throws as brought() does.
  Followed(const scene::Scene& of, const engine::Engine& by, const Limits& to);

  const scene::Scene& scene;
  const engine::Engine& engine;
  const Limits limits;
  const Looks looks;
  const std::vector<glm::dvec3> most;  ///< that a ray brings, by how many it may still have in a row
};

}  // namespace durero::render
