#pragma once
/// The option --engine of `durero trace`, `agree` and `render`.

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

#include "durero/engine/engine.hpp"

namespace durero::cli {

/// Adds the option; what it holds is then the name of an engine.
void add_engine(CLI::App& command, std::string& name);

/// What to say where an engine that knows no origins is asked for rays that have one.
std::string without_origins(const engine::Row& engine, std::string_view why);

}  // namespace durero::cli
