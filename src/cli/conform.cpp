// durero conform …: any program's hits held against the exact answers.
#include "conform.hpp"

#include "commands.hpp"
#include "description.hpp"

namespace durero::cli {

void add_conform(CLI::App& app, int& status) {
  auto* conform = app.add_subcommand("conform", "Hold any program's hits against the exact answers");
  conform->require_subcommand(1);
  conform->footer(examples({"conform list", "conform setup embree", "conform run embree --report found"}));
  add_conform_list(*conform, status);
  add_conform_make(*conform, status);
  add_conform_setup(*conform, status);
  add_conform_run(*conform, status);
  add_conform_shard(*conform, status);
  add_conform_merge(*conform, status);
  add_conform_answer(*conform, status);
  add_conform_judge(*conform, status);
  add_conform_show(*conform, status);
  add_conform_minimise(*conform, status);
  add_conform_bug(*conform, status);
  add_conform_fuzz(*conform, status);
  add_conform_compare(*conform, status);
  add_conform_history(*conform, status);
}

}  // namespace durero::cli
