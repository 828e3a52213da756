#include "blur_losses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "durero/scene/motion.hpp"
#include "durero/scene/stage.hpp"
#include "losses.hpp"

namespace durero::io {

void add_blur_losses(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view format) {
  const scene::Stage& stage = scene.stage();
  const auto add = [&](std::ptrdiff_t n, std::string_view one, std::string_view many) {
    add_loss(lost, static_cast<std::size_t>(n), one, many, fmt::format("left out: not written to {}", format));
  };
  add(stage.camera && stage.camera->aperture > 0, "lens", "lenses");
  add(stage.camera && stage.camera->shutter > 0, "shutter", "shutters");
  const bool camera_moves = stage.camera && stage.camera->motion != glm::dvec3(0);
  add(static_cast<std::ptrdiff_t>(scene::moving_elements(scene)) + camera_moves, "motion", "motions");
  add(std::ranges::count_if(stage.lights, [](const auto& light) { return !light.extent.is_point(); }),
      "shape of a light", "shapes of lights");
  add(std::ranges::count_if(stage.materials, [](const auto& material) { return !std::isinf(material.gloss); }), "gloss",
      "glosses");
}

}  // namespace durero::io
