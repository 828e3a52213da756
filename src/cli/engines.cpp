// durero engines, and the option --engine.
#include "engines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "commands.hpp"

namespace durero::cli {
namespace {

std::vector<std::string_view> names(bool with_origins_only = false) {
  std::vector<std::string_view> names;
  for (const engine::Row& row : engine::engines())
    if (row.honours_origins || !with_origins_only) names.push_back(row.name);
  return names;
}

int run() {
  for (const engine::Row& row : engine::engines())
    fmt::print("{:10} {}\n{:10} {}; {}\n", row.name, row.what, "",
               row.exact_bytes ? "the same bytes as exact" : "not the bytes of exact",
               row.honours_origins ? "honours the elements that a ray starts on"
                                   : "knows nothing of the elements that a ray starts on");
  return 0;
}

}  // namespace

void add_engine(CLI::App& command, std::string& name) {
  const auto is_engine = [](const std::string& given) {
    return engine::find(given) == nullptr
               ? fmt::format("no engine {}; expected one of {}", given, fmt::join(names(), ", "))
               : "";
  };
  command.add_option("--engine", name, fmt::format("One of {} (durero engines)", fmt::join(names(), ", ")))
      ->check(is_engine)
      ->capture_default_str();
}

std::string without_origins(const engine::Row& engine, std::string_view why) {
  return fmt::format("--engine {}: it knows nothing of the elements that a ray starts on, and {}; expected one of {}",
                     engine.name, why, fmt::join(names(true), ", "));
}

void add_engines(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("engines", "List the engines, and what each promises");
  command->callback([&status] { status = run(); });
}

}  // namespace durero::cli
