#pragma once
/// A view is a frame with all its open choices decided, and gives rays through any points of it.

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/scene.hpp"
#include "render/light/follower.hpp"

namespace durero::render {

/// A view of a scene by an engine, which must outlive it.
struct View {
  /// Decides the frame. Throws std::domain_error and std::out_of_range, as render does.
  View(const scene::Scene& drawn, const engine::Engine& asked, const RenderSettings& frame);

  /// The point of the window at `offset` from the centre of pixel (x, y) of the crop.
  glm::dvec2 point(std::uint32_t x, std::uint32_t y, const glm::dvec2& offset) const {
    return {crop.x + x + offset.x, crop.y + y + offset.y};
  }
  /// The colours that the rays through these points bring, in order.
  std::vector<PathRadiance> brought_by(std::span<const glm::dvec2> points) const;

  const scene::Scene& scene;
  const engine::Engine& engine;
  scene::PrimaryRays rays;  ///< the rays of the whole picture
  Crop crop;                ///< the part of the picture that is drawn
  PathLimits limits;
  Follower follower;
};

}  // namespace durero::render
