// durero conform minimise SYSTEM --case FAMILY/NUMBER --ray N: a failure made as small as it stays one.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "conform.hpp"
#include "conform_suite.hpp"
#include "conform_system.hpp"
#include "description.hpp"
#include "durero/conform/report/least_findings.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/standard_output.hpp"
#include "interrupted.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

using namespace conform;

struct ConformMinimiseOptions {
  SystemCall system;
  CaseCall of;
  std::string write;
  bool quiet = false;
};

Finding finding_of(const SuiteCase& whole, std::size_t ray, const Ask& ask, const Profile& profile) {
  SuiteCase of = with_ray_alone(whole, ray);
  const Claim claim = ask(of);
  const ClaimJudgement judgement = judge(of, 0, claim, profile);
  return {std::move(of), ray, claim, judgement};
}

int run(const ConformMinimiseOptions& options) {
  const System system = system_of(options.system);
  require_present(system);
  std::optional<io::OutputFile> question;
  if (!options.write.empty()) question.emplace(options.write);
  const SuiteOptions suite = suite_of(options.of.suite, system.profile);
  std::optional<Progress> progress(std::in_place, options.quiet, system.name, "questions");
  const Ask ask = counted(asking(system, {}, interrupted()), *progress);
  const Finding found = finding_of(case_of(options.of, suite), options.of.ray, ask, system.profile);
  std::string text =
      fmt::format("{}: expected {}; got {}\n", name(found.judgement.verdict), truth_words(found), claim_words(found));
  const bool is_wrong = is_failure(found.judgement.verdict);
  if (is_wrong) {
    const LeastFinding least = least_finding(found, system.profile, ask);
    text += '\n' + least_text(least, system.profile);
    if (question) question->write(least_question(least, system.profile));
  }
  progress.reset();
  if (question && is_wrong) question->commit();
  io::print(text);
  return is_wrong ? 1 : 0;
}

}  // namespace

void add_conform_minimise(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("minimise", "The fewest elements and roundest numbers that a system fails on");
  const auto options = std::make_shared<ConformMinimiseOptions>();
  add_system(*command, options->system);
  add_case(*command, options->of);
  add_question(*command, options->of.suite.question);
  command->add_option("--write", options->write,
                      "The file for the question with all its elements, as a system reads it");
  add_quiet(*command, options->quiet);
  command->footer(
      exit_status("the system is right about the ray", "it is not", "the system is absent, or the call is bad") +
      examples({"conform minimise embree --case tiny/0007 --ray 3"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
