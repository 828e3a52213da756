// durero conform minimise SYSTEM --case FAMILY/NUMBER --ray N: a failure made as small as it stays one.
#include <fmt/format.h>

#include <memory>

#include "conform.hpp"
#include "conform_suite.hpp"
#include "conform_system.hpp"
#include "durero/conform/least_findings.hpp"

namespace durero::cli {
namespace {

using namespace conform;

struct Options {
  std::string system;
  CaseCall of;
  std::string systems = default_systems();
};

Finding finding_of(const SuiteCase& whole, std::size_t ray, const Ask& ask, const Profile& profile) {
  SuiteCase of = with_ray_alone(whole, ray);
  const Claim claim = ask(of);
  const Judgement judgement = judge(of, 0, claim, profile);
  return {std::move(of), ray, claim, judgement};
}

int run(const Options& options) {
  const System system = find_system(options.system, options.systems, default_setups());
  require_present(system);
  const SuiteOptions suite = suite_of(options.of.suite, system.profile);
  const Ask ask = asking(system, {}, interrupted());
  const Finding found = finding_of(case_of(options.of, suite), options.of.ray, ask, system.profile);
  fmt::print("{}: expected {}; got {}\n", name(found.judgement.verdict), truth_words(found), claim_words(found));
  if (!is_failure(found.judgement.verdict)) return 0;
  fmt::print("\n{}", least_text(least_finding(found, system.profile, ask), system.profile));
  return 1;
}

}  // namespace

void add_conform_minimise(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("minimise", "The fewest elements and roundest numbers that a system fails on");
  const auto options = std::make_shared<Options>();
  command->add_option("SYSTEM", options->system, "The name of a system")->required();
  add_case(*command, options->of);
  add_systems(*command, options->systems);
  command->footer("Status 0: the system is right about the ray; 1: it is not; 2: it is absent, or a bad call.");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
