#pragma once
/// The subcommands of `durero conform`, and the options that several of them have.

#include <CLI/CLI.hpp>
#include <memory>

#include "durero/conform/suite.hpp"

namespace durero::cli {

void add_conform_list(CLI::App& conform, int& status);
void add_conform_make(CLI::App& conform, int& status);

/// Of which cases: --family, --seed, --rays, --types, --solids, --numbers. What they hold is then a suite's.
void add_suite_options(CLI::App& command, const std::shared_ptr<conform::SuiteOptions>& options);

}  // namespace durero::cli
