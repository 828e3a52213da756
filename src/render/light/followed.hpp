#pragma once
/// The data that all rays of a picture share.

#include <glm/vec3.hpp>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/render/light/light_cones.hpp"
#include "durero/render/light/whitted.hpp"
#include "render/texture/looks.hpp"

namespace durero::render {

class Caustics;

/// The data are prepared once, from a scene and an engine that outlive this object unedited.
struct TracingContext {
  /// Prepares the data. Throws as brought() does.
  TracingContext(const scene::Scene& of, const engine::Engine& by, const PathLimits& to, const Caustics* also);

  /// The look of an element's material.
  const TexturedMaterial& look_of(scene::ElementRef element) const { return looks.of(scene.material(element)); }

  const scene::Scene& scene;
  const engine::Engine& engine;
  const PathLimits limits;
  const Caustics* caustics;  ///< null where no such light is to be drawn
  const Looks looks;
  const LightCones cones;
  const std::vector<glm::dvec3> most;  ///< bounds on the colour of a ray, by the number that it may still have in a row
};

}  // namespace durero::render
