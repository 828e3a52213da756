// durero conform judge DIR HITS --profile P [--report DIR]: the hits of a program that anyone ran by hand.
#include <memory>
#include <optional>

#include "conform.hpp"
#include "description.hpp"
#include "durero/conform/ask/claims_file.hpp"
#include "durero/conform/ask/system_file.hpp"
#include "durero/conform/families/suite_file.hpp"
#include "durero/conform/report/report.hpp"
#include "durero/io/standard_output.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

using namespace conform;

struct ConformJudgeOptions {
  std::string directory, hits, profile, report;
  std::string systems = default_systems();
  bool quiet = false;
};

int run(const ConformJudgeOptions& options) {
  const Profile profile = read_profile(options.profile, options.systems);
  if (!options.report.empty()) require_room_for_reports(options.report);
  std::optional<Progress> progress(std::in_place, options.quiet, "judge: reading");
  const Suite suite = read_suite(options.directory);
  const std::vector<Claims> claims = read_claims(io::read_lines(options.hits), suite.cases);
  progress.emplace(options.quiet, "judge", "scenes", suite.cases.size());
  Report report{.title = profile.system, .profile = profile, .options = suite.options};
  for (std::size_t i = 0; i < suite.cases.size(); ++i) {
    report.tally.add(suite.cases[i], claims[i], profile);
    progress->add();
  }
  progress.reset();
  io::print(report_text(report));
  if (!options.report.empty()) write_reports(options.report, report);
  return report.tally.is_conformant() ? 0 : 1;
}

}  // namespace

void add_conform_judge(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("judge", "Judge the hits that a program gave for the rays of a suite");
  const auto options = std::make_shared<ConformJudgeOptions>();
  command->add_option("DIR", options->directory, "The suite, as durero conform make wrote it")->required();
  command->add_option("HITS", options->hits, "JSON lines, .csv or .npy; - is the standard input")->required();
  command->add_option("--profile", options->profile, "What the program claims: a system's name, or a file")->required();
  add_systems(*command, options->systems);
  command->add_option("--report", options->report, "The folder for JSON, JUnit XML, SARIF and a page of HTML");
  add_quiet(*command, options->quiet);
  command->footer(
      "JSON lines: "
      "{\"case\":\"generic/0000\",\"ray\":0,\"outcome\":\"hit\",\"element\":\"e0\",\"t\":4,\"point\":[0,0,4]}; "
      "CSV: columns\n"
      "case, ray and any of outcome, element, t, x, y, z; .npy: t of every ray in the suite's order, inf for a miss.\n"
      "A ray without a line is unanswered.\n\n" +
      exit_status("no answer is off", "some is, or none was judged", "the call or a file is bad") +
      examples({"conform judge suite hits.csv --profile embree"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
