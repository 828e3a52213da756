#pragma once
/// The subcommands of `durero`. Each declares its options and, when it is chosen, runs and sets the exit status:
/// 0 yes or done, 1 the answer is no, 2 the call or the input is bad (as io::InputError and io::FileError, which main
/// prints).

#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <vector>

#include "numbers.hpp"

namespace durero::cli {

/// A limit on the number of threads while it lives; 0: as many as the machine has.
class ThreadLimit {
 public:
  explicit ThreadLimit(std::size_t threads) {
    if (threads != 0) limit_.emplace(tbb::global_control::max_allowed_parallelism, threads);
  }

 private:
  std::optional<tbb::global_control> limit_;
};

/// The option --threads of a command.
inline void add_threads(CLI::App& command, std::size_t& threads) {
  command.add_option("--threads", threads, "How many threads; without it, as many as the machine has")
      ->check(whole_number(1, 1024));
}

/// A group of commands under one title in help.
struct CommandGroup {
  const char* title;
  std::vector<void (*)(CLI::App&, int&)> commands;  ///< each adds its command
};

/// The groups of this program, in the order that help shows them in: commands.cpp has all, and demo_commands.cpp those
/// of the demonstration.
std::vector<CommandGroup> command_groups();

/// The commands of the program, one a line, by the alphabet; ./x reads their names here.
void add_agree(CLI::App& app, int& status);
void add_check(CLI::App& app, int& status);
void add_completion(CLI::App& app, int& status);
void add_conform(CLI::App& app, int& status);
void add_convert(CLI::App& app, int& status);
void add_diff(CLI::App& app, int& status);
void add_distance(CLI::App& app, int& status);
void add_edit(CLI::App& app, int& status);
void add_engines(CLI::App& app, int& status);
void add_environment(CLI::App& app, int& status);
void add_export(CLI::App& app, int& status);
void add_fractal(CLI::App& app, int& status);
void add_help(CLI::App& app, int& status);
void add_import(CLI::App& app, int& status);
void add_man(CLI::App& app, int& status);
void add_merge(CLI::App& app, int& status);
void add_raster(CLI::App& app, int& status);
void add_render(CLI::App& app, int& status);
void add_shader(CLI::App& app, int& status);
void add_spec(CLI::App& app, int& status);
void add_stats(CLI::App& app, int& status);
void add_store(CLI::App& app, int& status);
void add_serve(CLI::App& app, int& status);
void add_trace(CLI::App& app, int& status);
void add_version(CLI::App& app, int& status);
void add_view(CLI::App& app, int& status);
void add_voxelise(CLI::App& app, int& status);
void add_watch(CLI::App& app, int& status);

void add_spec_export(CLI::App& spec, int& status);   ///< of spec: export
void add_spec_convert(CLI::App& spec, int& status);  ///< of spec: convert

}  // namespace durero::cli
