// durero conform history REPORT…: a system from version to version, on the same rays.
#include <memory>

#include "conform.hpp"
#include "description.hpp"
#include "durero/conform/report/comparison.hpp"
#include "durero/io/standard_output.hpp"

namespace durero::cli {
namespace {

int run(const std::vector<std::string>& reports) {
  std::vector<conform::Summary> versions;
  for (const std::string& report : reports) versions.push_back(conform::read_summary(io::read_source(report)));
  io::print(history_text(versions));
  return 0;
}

}  // namespace

void add_conform_history(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("history", "A system from version to version, on the same rays");
  const auto reports = std::make_shared<std::vector<std::string>>();
  command
      ->add_option("REPORT", *reports, "Files report.json of durero conform run --report, the earliest version first")
      ->required();
  command->footer(exit_status("they are shown", "the call or a report is bad, or they are not of the same rays") +
                  examples({"conform history old/mine/report.json new/mine/report.json"}));
  command->callback([reports, &status] { status = run(*reports); });
}

}  // namespace durero::cli
