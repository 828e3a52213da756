#pragma once
/// Engines whose structures serve only some rays, and are measured with these.

#include <memory>
#include <span>

#include "durero/engine/engine.hpp"

namespace durero::engine {

/// Answers segments that end at a light by accel::LightBuffer, and other rays as `analytic`.
std::unique_ptr<const Engine> light_buffer(const scene::Scene& scene);
/// Measures the light buffer with the shadow rays of the queries: segments from their first hits to each light.
Figures measured_light_buffer(const scene::Scene& scene, std::span<const scene::Query> queries);

/// Measures the item buffer with primary rays, as many as there are queries, spread evenly over the picture. Its engine
/// is structured<accel::ItemBuffer>.
Figures measured_item_buffer(const scene::Scene& scene, std::span<const scene::Query> queries);

}  // namespace durero::engine
