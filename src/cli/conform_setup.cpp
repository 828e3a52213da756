// durero conform setup SYSTEM…: installs systems, each into a folder of its own.
#include <fmt/format.h>

#include <csignal>
#include <memory>

#include "conform.hpp"
#include "durero/conform/setup.hpp"
#include "durero/conform/system_file.hpp"

namespace durero::cli {
namespace {

struct Options {
  std::vector<std::string> names;
  std::string systems = conform::default_systems();
};

std::atomic<bool> was_interrupted = false;

int set_up(const Options& options) {
  for (const std::string& name : options.names) {
    const conform::System system = conform::find_system(name, options.systems, conform::default_setups());
    fmt::print("{}: {}, into {}\n", name, system.title, system.setup);
    const auto say = [](std::string_view line) {
      fmt::print("{}\n", line);
      std::fflush(stdout);
    };
    conform::set_up(system, say, interrupted());
    fmt::print("{}: ready\n", name);
  }
  return 0;
}

}  // namespace

const std::atomic<bool>& interrupted() {
  static_assert(std::atomic<bool>::is_always_lock_free);  // so a signal handler may set it
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { was_interrupted = true; });
  return was_interrupted;
}

void add_systems(CLI::App& command, std::string& systems) {
  command.add_option("--systems", systems, "The folder of systems")->capture_default_str();
}

void add_conform_setup(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("setup", "Install systems, each into a folder of its own");
  const auto options = std::make_shared<Options>();
  command->add_option("SYSTEM", options->names, "Their names")->required();
  add_systems(*command, options->systems);
  command->footer(
      "Debian's packages are installed by apt-get, where this is run by root; the rest goes into\n"
      "$XDG_CACHE_HOME/durero/systems/SYSTEM, by default in ~/.cache, and is whole or not there.\n"
      "Status 0: all are ready; 2: one is not.");
  command->callback([options, &status] { status = set_up(*options); });
}

}  // namespace durero::cli
