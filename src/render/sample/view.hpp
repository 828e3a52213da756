#pragma once
/// A view is a frame with all its open choices decided, and gives rays through any points of it.

#include <array>
#include <glm/vec2.hpp>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/scene.hpp"
#include "render/light/follower.hpp"

namespace durero::render {

/// A sample of a pixel: the point of the window that its ray goes through, and the source of its other numbers.
struct EyeSample {
  glm::dvec2 point;
  SampleSource source;
};

/// A scene at a time of the shutter, ready to be seen.
struct Moment {
  /// The scene at that time; `resting` is the engine where no element moves. Throws as scene::Scene::at_time and
  /// PrimaryRays do.
  Moment(const scene::Scene& still, const engine::Engine& resting, double time, const RenderSettings& frame,
         const PathLimits& limits);

  const scene::Scene scene;
  const std::unique_ptr<const engine::Engine> own;  ///< null where no element moves
  const scene::PrimaryRays rays;
  const Follower follower;
};

/// The number of times that the samples of a moving scene have at most: the sample of number i has that of i modulo it.
/// A streak is then made of so many pictures.
inline constexpr std::uint32_t most_moments = 256;

/// A view of a scene by an engine, which must outlive it.
struct View {
  /// Decides the frame. Throws std::domain_error and std::out_of_range, as render does.
  View(const scene::Scene& drawn, const engine::Engine& asked, const RenderSettings& frame);

  /// The key of pixel (x, y) of the crop.
  std::uint64_t key(std::uint32_t x, std::uint32_t y) const { return key_of(crop.x + x, crop.y + y, seed); }
  /// The sample of that number of pixel (x, y) of the crop, which has that key, at `offset` from the centre.
  EyeSample sample(std::uint32_t x, std::uint32_t y, const glm::dvec2& offset, std::uint64_t key,
                   std::uint32_t number) const {
    return {{crop.x + x + offset.x, crop.y + y + offset.y}, {key, number, is_independent}};
  }
  /// The colours that the rays of these samples bring, in order.
  std::vector<PathRadiance> brought_by(std::span<const EyeSample> samples) const;

  const scene::Scene& scene;
  const engine::Engine& engine;
  scene::PrimaryRays rays;  ///< the rays of the whole picture
  Crop crop;                ///< the part of the picture that is drawn
  PathLimits limits;
  std::uint32_t seed;
  bool is_independent;  ///< whether each random number is drawn by itself
  Follower follower;

 private:
  const Moment& moment(std::uint32_t number) const;
  std::vector<PathRadiance> brought_in_motion(std::span<const EyeSample> samples) const;

  RenderSettings frame_;
  bool moves_;
  mutable std::array<std::unique_ptr<const Moment>, most_moments> moments_{};
  mutable std::array<std::once_flag, most_moments> made_{};
};

}  // namespace durero::render
