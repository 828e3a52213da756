#pragma once
/// Rendering is Algorithm II.1 of the source paper: for each pixel a ray, its closest intersection, and the colour that
/// it brings.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "durero/engine/engine.hpp"
#include "durero/render/light/integrator.hpp"
#include "durero/render/output/picture.hpp"
#include "durero/render/sample/sampling.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {

class Caustics;

/// A receiver of the share of the picture that is done, 0 to 1, called now and then from one thread at a time. An
/// exception that it throws ends the work, and leaves it.
using Progress = std::function<void(double)>;

/// The resolution of a stage that names none.
using scene::default_resolution;

/// A rectangle of pixels.
struct Crop {
  std::uint32_t x;         ///< column of the upper left pixel, from 0
  std::uint32_t y;         ///< row of the upper left pixel, from the top, from 0
  scene::Resolution size;  ///< the size in pixels, each way at least 1
};

/// The frame tells which part of a scene is drawn, and how.
struct RenderSettings {
  std::optional<scene::Resolution> size{};   ///< the whole picture's; else the scene's, else default_resolution
  std::optional<Crop> crop{};                ///< the only pixels of the whole picture that are drawn, as they are in it
  std::optional<std::uint32_t> max_depth{};  ///< the most rays in a row; else depth_of()
  double min_weight = 0;                     ///< the least weight of a followed ray, as PathLimits says
  Samples samples{};                         ///< the points of each pixel
  Integrator integrator{};                   ///< the way of following light
  ShadowRule shadows{};                      ///< what clear elements do to lights behind them
  /// Prepares an engine for a moving scene at another time; without it, the default engine is prepared.
  std::function<std::unique_ptr<const engine::Engine>(const scene::Scene&)> prepare{};
  const Caustics* caustics = nullptr;  ///< light that comes besides to matt surfaces
};

/// The counts of a picture's rays.
struct PathStatistics {
  std::uint32_t max_depth = 0;  ///< the limit on the depth
  std::uint64_t pixels = 0;     ///< the pixels that were drawn
  std::uint64_t samples = 0;    ///< rays from the eye, for all of them
  std::uint64_t rays = 0;       ///< the rays that were followed for them, without those to the lights
  std::uint64_t depths = 0;     ///< the sum over the pixels of the depth of the deepest one
  double left_out = 0;          ///< the greatest error of a component of a pixel for min_weight, linear
  std::uint64_t in_doubt = 0;   ///< pixels that had the most samples and are not known within the width
};

/// Draws the scene. Rows are shared among threads; every pixel is the same whatever their number. Throws
/// std::domain_error when the scene has no camera, or one that sees nothing, and std::out_of_range when the crop is
/// empty or not inside the picture. Preconditions: the engine honours origins; the samples keep to their ranges. Where
/// `reach` is given, it receives the counts of the rays.
Picture render(const scene::Scene& scene, const engine::Engine& engine, const Progress& progress = {},
               const RenderSettings& frame = {}, PathStatistics* reach = nullptr);

}  // namespace durero::render
