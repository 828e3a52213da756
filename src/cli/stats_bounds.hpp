#pragma once
/// The output of `durero stats --bounds` on bounding volumes.

#include <string>

#include "durero/engine/bounds.hpp"
#include "durero/io/json/json_writer.hpp"

namespace durero::cli {

/// The figures as tables: of all elements in volumes of each kind, then of each element in its own.
std::string bounds_text(const engine::BoundsFigures& figures, const scene::Scene& scene, bool no_times);

/// Writes the member `bounds` of an object.
void write_bounds(io::json::Writer& out, const engine::BoundsFigures& figures, const scene::Scene& scene,
                  bool no_times);

}  // namespace durero::cli
