#pragma once
/// The output of `durero stats --sphere-tracing`: which rays sphere tracing loses.

#include <string>
#include <vector>

#include "durero/engine/sphere_tracing_figures.hpp"
#include "durero/io/json/json_writer.hpp"

namespace durero::cli {

/// The figures at the engine's epsilon, and at greater ones, the greatest first.
std::vector<engine::SphereTracingFigures> sphere_tracing_figures(const scene::Scene& scene,
                                                                 std::span<const scene::Query> rays);

/// The figures as a table; empty where there are none.
std::string sphere_tracing_text(const std::vector<engine::SphereTracingFigures>& all);

/// Writes the member `sphere_tracing` of an object; nothing where there are none.
void write_sphere_tracing(io::json::Writer& out, const std::vector<engine::SphereTracingFigures>& all);

}  // namespace durero::cli
