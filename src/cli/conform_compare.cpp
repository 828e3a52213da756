// durero conform compare REPORT…: systems side by side on the same rays.
#include <memory>

#include "conform.hpp"
#include "description.hpp"
#include "durero/conform/report/comparison.hpp"
#include "durero/io/standard_output.hpp"

namespace durero::cli {
namespace {

struct ConformCompareOptions {
  std::vector<std::string> reports;
  bool markdown = false;
};

int run(const ConformCompareOptions& options) {
  std::vector<conform::Summary> systems;
  for (const std::string& report : options.reports) systems.push_back(conform::read_summary(io::read_source(report)));
  io::print(options.markdown ? comparison_markdown(std::move(systems)) : comparison_text(std::move(systems)));
  return 0;
}

}  // namespace

void add_conform_compare(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("compare", "Systems side by side on the same rays");
  const auto options = std::make_shared<ConformCompareOptions>();
  command->add_option("REPORT", options->reports, "Files report.json of durero conform run --report")->required();
  command->add_flag("--markdown", options->markdown, "As a table of Markdown");
  command->footer(exit_status("they are compared", "the call or a report is bad") +
                  examples({"conform compare found/*/report.json --markdown"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
