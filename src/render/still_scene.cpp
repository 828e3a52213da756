#include "durero/render/still_scene.hpp"

#include <algorithm>
#include <stdexcept>

#include "durero/scene/motion.hpp"

namespace durero::render {

const scene::Camera& still_camera(const scene::Scene& scene) {
  const scene::Stage& stage = scene.stage();
  if (!stage.camera) throw std::domain_error("the scene has no camera; expected one");
  if (stage.camera->aperture > 0) throw std::domain_error("the camera has a lens; expected a pinhole");
  if (scene::moves(scene))
    throw std::domain_error("something moves while the shutter is open; expected a scene at rest");
  const auto has_extent = [](const scene::Light& light) { return !light.extent.is_point(); };
  if (std::ranges::any_of(stage.lights, has_extent))
    throw std::domain_error("a light has an extent; expected point lights and directions");
  if (std::ranges::any_of(stage.lights, [](const scene::Light& light) { return light.cone.has_value(); }))
    throw std::domain_error("a light shines into a cone; expected lights that shine all around");
  return *stage.camera;
}

}  // namespace durero::render
