#pragma once
/// `durero spec refine`.

#include <CLI/CLI.hpp>

namespace durero::cli {

/// Adds the subcommand to `spec`.
void add_spec_refine(CLI::App& spec, int& status);

}  // namespace durero::cli
