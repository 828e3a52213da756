#pragma once
/// The techniques of `durero raster`: each draws a scene in its way, and says in a line what it took.

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "durero/render/output/picture.hpp"
#include "durero/scene/stage.hpp"
#include "scene_tracer.hpp"

namespace durero::cli {

/// The options of all techniques, as they stand in the call.
struct RasterOptions {
  std::string scene, out, size, engine{engine::default_engine};
  std::string bias{"texel"}, order{"depth"}, picture, towards, mirror;
  std::uint32_t map = 1024, samples = 1;
  double height = 60;
  std::optional<std::uint32_t> max_depth{};
  std::size_t threads = 0;
  bool beside = false;

  /// The pixels that are drawn for one of the picture, each way.
  std::uint32_t finer() const { return static_cast<std::uint32_t>(std::lround(std::sqrt(samples))); }
};

/// The drawing of a technique.
struct RasterResult {
  render::Picture picture;  ///< by the technique
  render::Picture rays;     ///< by rays
  std::string figures;      ///< the line that says what it took, without an end
};

/// A drawing of areas, SVG, in that size.
using Drawing = std::string (*)(const SceneTracer& tracer, scene::Resolution size);

std::string shadows_drawing(const SceneTracer& tracer, scene::Resolution size);
std::string weiler_drawing(const SceneTracer& tracer, scene::Resolution size);

/// A technique, which draws in that size: finer() times that of the picture. Throws std::domain_error for a scene that
/// it does not draw.
using Technique = RasterResult (*)(const RasterOptions& options, const SceneTracer& tracer, scene::Resolution size);

RasterResult shadows_technique(const RasterOptions& options, const SceneTracer& tracer, scene::Resolution size);
RasterResult weiler_technique(const RasterOptions& options, const SceneTracer& tracer, scene::Resolution size);
RasterResult depth_map_technique(const RasterOptions& options, const SceneTracer& tracer, scene::Resolution size);
RasterResult projected_technique(const RasterOptions& options, const SceneTracer& tracer, scene::Resolution size);
RasterResult transparent_technique(const RasterOptions& options, const SceneTracer& tracer, scene::Resolution size);
RasterResult mirror_technique(const RasterOptions& options, const SceneTracer& tracer, scene::Resolution size);

}  // namespace durero::cli
