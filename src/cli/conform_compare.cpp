// durero conform compare REPORT…: systems side by side on the same rays.
#include <fmt/format.h>

#include <memory>

#include "conform.hpp"
#include "durero/conform/comparison.hpp"

namespace durero::cli {
namespace {

struct Options {
  std::vector<std::string> reports;
  bool markdown = false;
};

int run(const Options& options) {
  std::vector<conform::Summary> systems;
  for (const std::string& report : options.reports) systems.push_back(conform::read_summary(io::read_source(report)));
  fmt::print("{}", options.markdown ? comparison_markdown(std::move(systems)) : comparison_text(std::move(systems)));
  return 0;
}

}  // namespace

void add_conform_compare(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("compare", "Systems side by side on the same rays");
  const auto options = std::make_shared<Options>();
  command->add_option("REPORT", options->reports, "Files report.json of durero conform run --report")->required();
  command->add_flag("--markdown", options->markdown, "As a table of Markdown");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
