#pragma once
/// Algorithm II.1 of the source paper with the colour of its sections II-D and II-E: for each pixel a ray, its closest
/// intersection, Lambert's law for each light that the point sees.

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/model/tipos.hpp"
#include "durero/render/image.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/scene.hpp"

namespace durero::render {

/// Called now and then, from one thread at a time, with the share of rows that are done, 0 to 1.
using Progress = std::function<void(double)>;

/// Of a stage that names none.
using scene::default_resolution;
/// @{ What a stage that leaves something open is drawn with.
inline constexpr glm::dvec3 default_background{0, 0, 0};
inline constexpr glm::dvec3 default_color{0.8, 0.8, 0.8};
/// @}

/// The colour that each ray brings: background where it meets nothing or where no nearest point exists; otherwise the
/// element's colour times the sum over the lights of max(0, L·N)·colour, each light only where no element stands
/// between. Shadow rays start on the elements hit, so a surface does not shadow itself by rounding. Of several
/// elements at one point the first by name gives colour and normal. Precondition: the engine honours origins.
std::vector<glm::dvec3> colors(const scene::Scene& scene, const engine::Engine& engine,
                               std::span<const scene::Query> rays);

/// A rectangle of pixels.
struct Crop {
  std::uint32_t x;         ///< of the upper left pixel, from the left, from 0
  std::uint32_t y;         ///< of the upper left pixel, from the top, from 0
  scene::Resolution size;  ///< how many pixels, each way at least 1
};

/// What of the scene is drawn.
struct Frame {
  std::optional<scene::Resolution> size{};  ///< of the whole picture; else the scene's, else default_resolution
  std::optional<Crop> crop{};               ///< these pixels of the whole picture alone, and as they are in it
};

/// Draws the scene. Rows are shared among threads; every pixel is the same whatever their number.
/// Throws std::domain_error when the scene has no camera, or one that sees nothing, and std::out_of_range when the crop
/// is empty or not inside the picture. Precondition as above.
Image render(const scene::Scene& scene, const engine::Engine& engine, const Progress& progress = {},
             const Frame& frame = {});

}  // namespace durero::render
