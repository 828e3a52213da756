#pragma once
/// The engines whose structures are for some rays alone, and measured with those.

#include <memory>
#include <span>

#include "durero/engine/engine.hpp"

namespace durero::engine {

/// Segments that end at a light by accel::LightBuffer, other rays as `analytic`.
std::unique_ptr<const Engine> light_buffer(const scene::Scene& scene);
/// Measured with the segments from where the rays hit first to each of the lights.
Figures measured_light_buffer(const scene::Scene& scene, std::span<const scene::Query> queries);

/// The item buffer's engine is structured<accel::ItemBuffer>: measured with as many primary rays as there are queries,
/// evenly from all over the picture.
Figures measured_item_buffer(const scene::Scene& scene, std::span<const scene::Query> queries);

}  // namespace durero::engine
