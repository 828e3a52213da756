#pragma once
/// The engine for scenes with bodies: elements of the tables by an engine of the table of engines, bodies by their
/// figures, and the nearest of both exactly, ties included.

#include <memory>
#include <string_view>

#include "durero/engine/engine.hpp"
#include "durero/scene/grouped_scene.hpp"

namespace durero::composed {

/// engine::prepared, for scenes that may have bodies. The bodies are asked exactly, whatever the row.
std::unique_ptr<const engine::Engine> prepared(const engine::EngineRow& row, std::string_view hierarchy,
                                               const scene::GroupedScene& input);

/// The engine of a scene without groups.
std::unique_ptr<const engine::Engine> prepared(const engine::EngineRow& row, const scene::Scene& scene);

}  // namespace durero::composed
