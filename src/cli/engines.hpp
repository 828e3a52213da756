#pragma once
/// The options --engine and --hierarchy of `durero trace`, `agree`, `render` and `stats`.

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <string_view>

#include "durero/engine/engine.hpp"
#include "durero/scene/grouped_scene.hpp"

namespace durero::cli {

/// Adds the option; what it holds is then the name of an engine.
void add_engine(CLI::App& command, std::string& name);

/// Adds the option --hierarchy; what it holds is then `automatic` or `hand`.
void add_hierarchy(CLI::App& command, std::string& hierarchy);

/// The engine, ready for the scene, with its hierarchy made so. Throws std::invalid_argument where it is to be by hand
/// and the engine follows no groups.
std::unique_ptr<const engine::Engine> prepared(const engine::Row& engine, std::string_view hierarchy,
                                               const scene::GroupedScene& input);

/// What to say where an engine that knows no origins is asked for rays that have one.
std::string without_origins(const engine::Row& engine, std::string_view why);

}  // namespace durero::cli
