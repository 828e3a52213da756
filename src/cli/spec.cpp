// durero spec …: the Z text itself.
#include "commands.hpp"

namespace durero::cli {

void add_spec(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("spec", "Work with the Z text");
  command->require_subcommand(1);
  add_spec_export(*command, status);
}

}  // namespace durero::cli
