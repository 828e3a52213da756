#pragma once
/// The options --engine, --hierarchy and --with of `durero trace`, `agree`, `render` and `stats`.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "durero/engine/engine.hpp"

namespace durero::cli {

/// Adds the option --engine; its value is the name of an engine.
void add_engine(CLI::App& command, std::string& name);
/// The option --max-depth of a command that draws.
void add_max_depth(CLI::App& command, std::optional<std::uint32_t>& max_depth);

/// Adds the option --hierarchy; its value is `automatic` or `hand`.
void add_hierarchy(CLI::App& command, std::string& hierarchy);

/// Adds the option --with, a Z text by which the scene is read and its rays are answered. It must be added after the
/// two above, which it excludes.
void add_with(CLI::App& command, std::string& file);

/// The message about an engine that honours no origins and is asked for rays that have one.
std::string without_origins(const engine::EngineRow& engine, std::string_view why);

}  // namespace durero::cli
