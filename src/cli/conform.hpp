#pragma once
/// The subcommands of `durero conform`, and the options that several of them have.

#include <CLI/CLI.hpp>
#include <atomic>
#include <memory>
#include <string>

#include "durero/conform/suite.hpp"

namespace durero::cli {

void add_conform_list(CLI::App& conform, int& status);
void add_conform_make(CLI::App& conform, int& status);
void add_conform_show(CLI::App& conform, int& status);
void add_conform_judge(CLI::App& conform, int& status);
void add_conform_setup(CLI::App& conform, int& status);
void add_conform_run(CLI::App& conform, int& status);
void add_conform_answer(CLI::App& conform, int& status);
void add_conform_compare(CLI::App& conform, int& status);

using SuiteCall = std::shared_ptr<conform::SuiteOptions>;

/// Of which rays: --family, --seed, --rays.
void add_rays(CLI::App& command, const SuiteCall& options);
void add_seed(CLI::App& command, const SuiteCall& options);
/// Of which elements and numbers, which a system's profile says of its own suite: --types, --solids, --numbers.
void add_elements(CLI::App& command, const SuiteCall& options);

/// The option --systems of a command.
void add_systems(CLI::App& command, std::string& systems);

/// Is set when the user interrupts the program (SIGINT, SIGTERM), from this call on.
const std::atomic<bool>& interrupted();

}  // namespace durero::cli
