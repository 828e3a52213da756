#pragma once
/// What is drawn, with all that a frame leaves open decided, and rays through any points of it.

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/render/render.hpp"
#include "durero/render/whitted.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/scene.hpp"
#include "follower.hpp"

namespace durero::render {

/// Of a scene and an engine that outlive it.
struct View {
  /// Throws std::domain_error and std::out_of_range, as render does.
  View(const scene::Scene& drawn, const engine::Engine& asked, const Frame& frame);

  /// The point of the window that lies by `offset` from the centre of pixel (x, y) of the crop.
  glm::dvec2 point(std::uint32_t x, std::uint32_t y, const glm::dvec2& offset) const {
    return {crop.x + x + offset.x, crop.y + y + offset.y};
  }
  /// What the rays through these points bring, in order.
  std::vector<Brought> brought_by(std::span<const glm::dvec2> points) const;

  const scene::Scene& scene;
  const engine::Engine& engine;
  scene::PrimaryRays rays;  ///< of the whole picture
  Crop crop;                ///< of it, what is drawn
  Limits limits;
  Follower follower;
};

}  // namespace durero::render
