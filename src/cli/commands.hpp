#pragma once
/// The subcommands of `durero`. Each declares its options and, when it is chosen, runs and sets the exit status:
/// 0 yes or done, 1 the answer is no, 2 the call or the input is bad (as io::InputError and io::FileError, which main
/// prints).

#include <CLI/CLI.hpp>

namespace durero::cli {

void add_check(CLI::App& app, int& status);
void add_edit(CLI::App& app, int& status);
void add_trace(CLI::App& app, int& status);
void add_import(CLI::App& app, int& status);
void add_export(CLI::App& app, int& status);

}  // namespace durero::cli
