// durero conform setup SYSTEM…: installs systems, each into a folder of its own.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "conform.hpp"
#include "description.hpp"
#include "durero/conform/ask/setup.hpp"
#include "durero/conform/ask/system_file.hpp"
#include "durero/io/standard_output.hpp"
#include "interrupted.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

struct ConformSetupOptions {
  std::vector<std::string> names;
  std::string systems = conform::default_systems();
  bool quiet = false;
};

int set_up(const ConformSetupOptions& options) {
  for (const std::string& name : options.names) {
    const conform::System system = conform::find_system(name, options.systems, conform::default_setups());
    io::print(fmt::format("{}: {}, into {}\n", name, system.title, system.setup));
    std::optional<Progress> step;
    const auto say = [&](std::string_view line) {
      step.reset();
      io::print(fmt::format("{}\n", line));
      step.emplace(options.quiet, name);
    };
    conform::set_up(system, say, interrupted());
    step.reset();
    io::print(fmt::format("{}: ready\n", name));
  }
  return 0;
}

}  // namespace

void add_systems(CLI::App& command, std::string& systems) {
  command.add_option("--systems", systems, "The folder of systems; without it, the one that comes with durero");
}

void add_conform_setup(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("setup", "Install systems, each into a folder of its own");
  const auto options = std::make_shared<ConformSetupOptions>();
  command->add_option("SYSTEM", options->names, "Their names")->required();
  add_systems(*command, options->systems);
  add_quiet(*command, options->quiet);
  command->footer(
      "Debian's packages are installed by apt-get, where this is run by root; the rest goes into\n"
      "$XDG_CACHE_HOME/durero/systems/SYSTEM, by default in ~/.cache, and is whole or not there.\n\n" +
      exit_status("all are ready", "one is not, or the call is bad") + examples({"conform setup embree bullet"}));
  command->callback([options, &status] { status = set_up(*options); });
}

}  // namespace durero::cli
