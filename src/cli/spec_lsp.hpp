#pragma once
/// The subcommand `durero spec lsp`.

#include <CLI/CLI.hpp>

namespace durero::cli {

void add_spec_lsp(CLI::App& spec, int& status);

}  // namespace durero::cli
