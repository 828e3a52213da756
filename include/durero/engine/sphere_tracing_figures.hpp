#pragma once
/// The losses of sphere tracing: its ends of some rays, beside the exact first hits.

#include <cstdint>
#include <span>

#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::engine {

/// Rays by what becomes of them, at one ε.
struct SphereTracingFigures {
  double epsilon = 0;        ///< the length below which a distance counts as none
  std::uint64_t rays = 0;    ///< all of them
  std::uint64_t steps = 0;   ///< of all rays together
  std::uint64_t right = 0;   ///< the element, or the miss, that is exact
  std::uint64_t grazed = 0;  ///< end near an element, though the exact answer is a miss
  std::uint64_t other = 0;   ///< end near another element than those met first, or where none is first
  std::uint64_t tired = 0;   ///< given up
  std::uint64_t passed = 0;  ///< went on beyond the exact first hit; there are none
};

/// The figures of some rays; ε is a length greater than 0, or 0 for the engine's own.
SphereTracingFigures sphere_tracing_figures(const scene::Scene& scene, std::span<const scene::Query> queries,
                                            double epsilon);

}  // namespace durero::engine
