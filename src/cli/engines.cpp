// durero engines, and the option --engine.
#include "engines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "commands.hpp"
#include "description.hpp"
#include "durero/io/standard_output.hpp"
#include "numbers.hpp"

namespace durero::cli {
namespace {

std::vector<std::string> names(bool with_origins_only = false) {
  std::vector<std::string> names;
  for (const engine::Row& row : engine::engines())
    if (row.honours_origins || !with_origins_only) names.emplace_back(row.name);
  return names;
}

int run() {
  std::string text;
  for (const engine::Row& row : engine::engines())
    text += fmt::format("{:12} {}\n{:12} {}; {}\n", row.name, row.what, "",
                        row.exact_bytes ? "the same bytes as exact" : "not the bytes of exact",
                        row.honours_origins ? "honours the elements that a ray starts on"
                                            : "knows nothing of the elements that a ray starts on");
  io::print(text);
  return 0;
}

}  // namespace

void add_engine(CLI::App& command, std::string& name) {
  command.add_option("--engine", name, "What computes the hits, as durero engines lists")
      ->check(one_of("engine", names()))
      ->capture_default_str();
}

std::string without_origins(const engine::Row& engine, std::string_view why) {
  return fmt::format("--engine {}: it knows nothing of the elements that a ray starts on, and {}; expected one of {}",
                     engine.name, why, fmt::join(names(true), ", "));
}

void add_engines(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("engines", "List the engines, and what each promises");
  command->footer(exit_status("they are listed", "the call is bad") + examples({"engines"}));
  command->callback([&status] { status = run(); });
}

}  // namespace durero::cli
