#include "blur_losses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "durero/scene/motion.hpp"
#include "durero/scene/stage.hpp"
#include "losses.hpp"

namespace durero::io {

namespace {

/// A line of things that are left out, where there are some.
struct LeftOut {
  std::vector<std::string>& lost;
  std::string fate;

  void add(std::ptrdiff_t n, std::string_view one, std::string_view many) const {
    add_loss(lost, static_cast<std::size_t>(n), one, many, fate);
  }
};

LeftOut left_out(std::vector<std::string>& lost, std::string_view format) {
  return {lost, fmt::format("left out: not written to {}", format)};
}

}  // namespace

void add_motion_losses(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view format) {
  const scene::Stage& stage = scene.stage();
  const LeftOut out = left_out(lost, format);
  out.add(stage.camera && stage.camera->shutter > 0, "shutter", "shutters");
  const bool camera_moves = stage.camera && stage.camera->motion != glm::dvec3(0);
  out.add(static_cast<std::ptrdiff_t>(scene::moving_elements(scene)) + camera_moves, "motion", "motions");
  out.add(std::ranges::count_if(stage.materials, [](const auto& material) { return !std::isinf(material.gloss); }),
          "gloss", "glosses");
}

void add_extent_losses(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view format) {
  left_out(lost, format)
      .add(std::ranges::count_if(scene.stage().lights, [](const auto& light) { return !light.extent.is_point(); }),
           "shape of a light", "shapes of lights");
}

void add_blur_losses(std::vector<std::string>& lost, const scene::Scene& scene, std::string_view format) {
  const scene::Stage& stage = scene.stage();
  const LeftOut out = left_out(lost, format);
  out.add(stage.camera && stage.camera->aperture > 0, "lens", "lenses");
  add_extent_losses(lost, scene, format);
  out.add(std::ranges::count_if(stage.lights, [](const auto& light) { return light.cone.has_value(); }),
          "cone of a light", "cones of lights");
  add_motion_losses(lost, scene, format);
}

}  // namespace durero::io
