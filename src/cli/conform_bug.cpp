// durero conform bug SYSTEM CASE [--ray N]: a failure as one would file it.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "conform.hpp"
#include "conform_suite.hpp"
#include "conform_system.hpp"
#include "description.hpp"
#include "durero/conform/report/bug_report.hpp"
#include "durero/conform/report/least_findings.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/standard_output.hpp"
#include "interrupted.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

using namespace conform;

struct ConformBugOptions {
  SystemCall system;
  CaseCall of;
  bool has_ray = false;
  std::string output = "-", reproducer;
  bool quiet = false;
};

/// The worst failure of the case, or that of its ray; nothing where the system is right. Fills in the version that the
/// system gives.
std::optional<Finding> failure_of(const System& system, const SuiteCase& of, const ConformBugOptions& options,
                                  std::string& version) {
  Tally tally;
  const auto judge_all = [&](const SuiteCase& asked, std::span<const Claim> claims) {
    tally.add(asked, claims, system.profile);
  };
  const auto clauses = [&](const SuiteCase& asked) {
    std::vector<std::string> all = CaseJudge(asked, system.profile).outside();
    for (std::size_t ray = 0; options.has_ray && ray < all.size(); ++ray) {
      if (ray != options.of.ray) all[ray] = "another is asked";
    }
    return all;
  };
  version = run_system(system, {1, [&](std::size_t) { return of; }, clauses}, {}, judge_all, interrupted()).says;
  std::optional<Finding> worst;
  for (const FamilyTally& family : tally.families()) {
    for (const std::optional<Finding>& finding : family.worst) {
      if (finding && (!worst || is_gross(finding->judgement.verdict) > is_gross(worst->judgement.verdict)))
        worst = finding;
    }
  }
  return worst;
}

/// Adds the reproducer and its output, where the system has a template, which asks for first hits.
void add_reproducer(BugReport& bug, const ConformBugOptions& options) {
  if (bug.system.reproducer.program.empty() || options.of.suite.question != SuiteCall().question) return;
  using Path = std::filesystem::path;
  bug.file = options.reproducer.empty() ? Path(bug.system.reproducer.program).stem().string()
                                        : Path(options.reproducer).filename().string();
  bug.program = reproducer_text(bug.system, bug.least.finding, about_bug(bug), bug.file);
  bug.reproduction = reproduced(bug.system, bug.least.finding, bug.program, bug.file, interrupted());
}

int run(const ConformBugOptions& options) {
  if (!options.reproducer.empty() && options.of.suite.question != SuiteCall().question)
    throw std::runtime_error(fmt::format("a reproducer of the question {}; expected a call without --reproducer",
                                         options.of.suite.question));
  const System system = system_of(options.system);
  require_present(system);
  if (!options.reproducer.empty() && system.reproducer.program.empty())
    throw std::runtime_error(
        fmt::format("{} has no template of a reproducer; expected a call without --reproducer", system.name));
  io::OutputFile output(options.output);
  std::optional<io::OutputFile> reproducer;
  if (!options.reproducer.empty()) reproducer.emplace(options.reproducer);
  const SuiteOptions suite = suite_of(options.of.suite, system.profile);
  std::optional<Progress> progress(std::in_place, options.quiet, system.name, "questions");
  BugReport bug{.system = system, .asker = std::string("durero ") + DURERO_VERSION};
  const auto failure = failure_of(system, case_of(options.of, suite), options, bug.version);
  if (!failure) {
    io::print(fmt::format("{} is right about {}\n", system.name, options.of.name));
    return 0;
  }
  const Ask ask = counted(asking(system, {}, interrupted()), *progress);
  bug.call = fmt::format("durero conform bug {} {} --ray {}",
                         words_of_system(options.system.system, options.system.profile), options.of.name, failure->ray);
  if (options.of.suite.seed != SuiteCall().seed) bug.call += fmt::format(" --seed {}", options.of.suite.seed);
  bug.least = least_finding(*failure, system.profile, ask);
  bug.variations = variations(bug.least.finding, system.profile, ask);
  if (options.of.suite.question != SuiteCall().question)
    bug.call += fmt::format(" --question {}", options.of.suite.question);
  if (options.of.suite.faces != SuiteCall().faces) bug.call += fmt::format(" --faces {}", options.of.suite.faces);
  add_reproducer(bug, options);
  progress.reset();
  if (reproducer) {
    reproducer->write(bug.program);
    reproducer->commit();
  }
  output.write(bug_text(bug, reproducer.has_value()));
  output.commit();
  return 1;
}

}  // namespace

void add_conform_bug(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("bug", "A failure as one would file it: small, explained, with a reproducer");
  const auto options = std::make_shared<ConformBugOptions>();
  add_system(*command, options->system);
  command->add_option("CASE", options->of.name, "Which, such as tiny/0007")->required();
  auto* ray = add_ray(*command, options->of);
  add_question(*command, options->of.suite.question);
  add_quiet(*command, options->quiet);
  command->add_option("--output", options->output, "The file for the report; without it, the standard output");
  command->add_option("--reproducer", options->reproducer,
                      "The file for the reproducer, which then does not stand in the report");
  command->footer("Without --ray it is the worst failure of the case.\n\n" +
                  exit_status("the system is right about it", "it is not", "the system is absent, or the call is bad") +
                  examples({"conform bug embree tiny/0007 --output report.md"}));
  command->callback([options, ray, &status] {
    options->has_ray = ray->count() > 0;
    status = run(*options);
  });
}

}  // namespace durero::cli
