#pragma once
/// Algorithm II.1 of the source paper: for each pixel a ray, its closest intersection, and the colour that it brings.

#include <cstdint>
#include <functional>
#include <optional>

#include "durero/engine/engine.hpp"
#include "durero/render/image.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/scene.hpp"

namespace durero::render {

/// Called now and then, from one thread at a time, with the share of rows that are done, 0 to 1.
using Progress = std::function<void(double)>;

/// Of a stage that names none.
using scene::default_resolution;

/// A rectangle of pixels.
struct Crop {
  std::uint32_t x;         ///< of the upper left pixel, from the left, from 0
  std::uint32_t y;         ///< of the upper left pixel, from the top, from 0
  scene::Resolution size;  ///< how many pixels, each way at least 1
};

/// What of the scene is drawn.
struct Frame {
  std::optional<scene::Resolution> size{};   ///< of the whole picture; else the scene's, else default_resolution
  std::optional<Crop> crop{};                ///< these pixels of the whole picture alone, and as they are in it
  std::optional<std::uint32_t> max_depth{};  ///< rays in a row; else as depth_of says
};

/// Draws the scene. Rows are shared among threads; every pixel is the same whatever their number.
/// Throws std::domain_error when the scene has no camera, or one that sees nothing, and std::out_of_range when the crop
/// is empty or not inside the picture. Precondition: the engine honours origins.
Image render(const scene::Scene& scene, const engine::Engine& engine, const Progress& progress = {},
             const Frame& frame = {});

}  // namespace durero::render
