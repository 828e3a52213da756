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

/// The parameter at which a ray first meets an element, be it a body or not, exactly. Precondition: it meets it, and
/// not at points as near to its origin as one likes.
surface::exact::Parameter first_parameter(const scene::Scene& scene, const scene::Query& query,
                                          scene::ElementRef element);

}  // namespace durero::composed
