#pragma once
/// The data that all rays of a picture share.

#include <glm/vec3.hpp>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/render/light/whitted.hpp"
#include "render/texture/looks.hpp"

namespace durero::render {

/// The data are prepared once, from a scene and an engine that outlive this object unedited.
struct Followed {
  /// Prepares the data. Throws as brought() does.
  Followed(const scene::Scene& of, const engine::Engine& by, const Limits& to);

  const scene::Scene& scene;
  const engine::Engine& engine;
  const Limits limits;
  const Looks looks;
  const std::vector<glm::dvec3> most;  ///< bounds on the colour of a ray, by the number that it may still have in a row
};

}  // namespace durero::render
