#pragma once
/// The subcommands of `durero conform`.

#include <CLI/CLI.hpp>
#include <string>

namespace durero::cli {

void add_conform_list(CLI::App& conform, int& status);
void add_conform_make(CLI::App& conform, int& status);
void add_conform_setup(CLI::App& conform, int& status);
void add_conform_run(CLI::App& conform, int& status);
void add_conform_shard(CLI::App& conform, int& status);
void add_conform_merge(CLI::App& conform, int& status);
void add_conform_answer(CLI::App& conform, int& status);
void add_conform_judge(CLI::App& conform, int& status);
void add_conform_show(CLI::App& conform, int& status);
void add_conform_minimise(CLI::App& conform, int& status);
void add_conform_bug(CLI::App& conform, int& status);
void add_conform_fuzz(CLI::App& conform, int& status);
void add_conform_compare(CLI::App& conform, int& status);
void add_conform_history(CLI::App& conform, int& status);

/// The option --systems of a command.
void add_systems(CLI::App& command, std::string& systems);

}  // namespace durero::cli
