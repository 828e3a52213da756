// durero conform bug SYSTEM CASE [--ray N]: a failure as one would file it.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "conform.hpp"
#include "conform_suite.hpp"
#include "conform_system.hpp"
#include "durero/conform/bug_report.hpp"
#include "durero/conform/least_findings.hpp"
#include "durero/io/output_file.hpp"

namespace durero::cli {
namespace {

using namespace conform;

struct Options {
  std::string system;
  CaseCall of;
  bool has_ray = false;
  std::string systems = default_systems(), output = "-", reproducer;
};

/// The worst failure of the case, or that of its ray; nothing where the system is right. Fills in what it says it is.
std::optional<Finding> failure_of(const System& system, const SuiteCase& of, const Options& options,
                                  std::string& version) {
  Tally tally;
  const auto judge_all = [&](const SuiteCase& asked, std::span<const Claim> claims) {
    tally.add(asked, claims, system.profile);
  };
  const auto is_asked = [&](const SuiteCase& asked, std::size_t ray) {
    return options.has_ray && ray != options.of.ray ? "another is asked" : outside(asked, ray, system.profile);
  };
  version = run_system(system, {1, [&](std::size_t) { return of; }, is_asked}, {}, judge_all, interrupted()).says;
  std::optional<Finding> worst;
  for (const FamilyTally& family : tally.families()) {
    for (const std::optional<Finding>& finding : family.worst) {
      if (finding && (!worst || is_gross(finding->judgement.verdict) > is_gross(worst->judgement.verdict)))
        worst = finding;
    }
  }
  return worst;
}

/// Where the system has a template: the reproducer, run.
void add_reproducer(BugReport& bug, const Options& options) {
  if (bug.system.reproducer.program.empty()) return;
  using Path = std::filesystem::path;
  bug.file = options.reproducer.empty() ? Path(bug.system.reproducer.program).stem().string()
                                        : Path(options.reproducer).filename().string();
  bug.program = reproducer_text(bug.system, bug.least.finding, about_bug(bug), bug.file);
  bug.reproduction = reproduced(bug.system, bug.least.finding, bug.program, bug.file, interrupted());
}

int run(const Options& options) {
  const System system = find_system(options.system, options.systems, default_setups());
  require_present(system);
  if (!options.reproducer.empty() && system.reproducer.program.empty())
    throw std::runtime_error(
        fmt::format("{} has no template of a reproducer; expected a call without --reproducer", system.name));
  const SuiteOptions suite = suite_of(options.of.suite, system.profile);
  BugReport bug{.system = system, .asker = std::string("durero ") + DURERO_VERSION};
  const auto failure = failure_of(system, case_of(options.of, suite), options, bug.version);
  if (!failure) {
    fmt::print("{} is right about {}\n", system.name, options.of.name);
    return 0;
  }
  const Ask ask = asking(system, {}, interrupted());
  bug.call = fmt::format("durero conform bug {} {} --ray {}", system.name, options.of.name, failure->ray);
  if (options.of.suite.seed != SuiteCall().seed) bug.call += fmt::format(" --seed {}", options.of.suite.seed);
  bug.least = least_finding(*failure, system.profile, ask);
  bug.variations = variations(bug.least.finding, system.profile, ask);
  add_reproducer(bug, options);
  if (!options.reproducer.empty()) io::write_file(options.reproducer, bug.program);
  io::write_file(options.output, bug_text(bug, !options.reproducer.empty()));
  return 1;
}

}  // namespace

void add_conform_bug(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("bug", "A failure as one would file it: small, explained, with a reproducer");
  const auto options = std::make_shared<Options>();
  command->add_option("SYSTEM", options->system, "The name of a system")->required();
  command->add_option("CASE", options->of.name, "Which, such as tiny/0007")->required();
  auto* ray = add_ray(*command, options->of);
  add_systems(*command, options->systems);
  command->add_option("--output", options->output, "The file for the report; without it, the standard output");
  command->add_option("--reproducer", options->reproducer,
                      "The file for the reproducer, which then does not stand in the report");
  command->footer(
      "Without --ray it is the worst failure of the case.\n"
      "Status 0: the system is right about it; 1: it is not; 2: it is absent, or a bad call.");
  command->callback([options, ray, &status] {
    options->has_ray = ray->count() > 0;
    status = run(*options);
  });
}

}  // namespace durero::cli
