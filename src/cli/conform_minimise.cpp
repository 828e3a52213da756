// durero conform minimise SYSTEM --case FAMILY/NUMBER --ray N: a failure made as small as it stays one.
#include <fmt/format.h>

#include <array>
#include <memory>
#include <sstream>

#include "conform.hpp"
#include "conform_suite.hpp"
#include "durero/conform/explanation.hpp"
#include "durero/conform/minimise.hpp"
#include "durero/conform/question.hpp"
#include "durero/conform/report.hpp"
#include "durero/conform/setup.hpp"
#include "durero/io/number_text.hpp"

namespace durero::cli {
namespace {

using namespace conform;

struct Options {
  std::string system;
  CaseCall of;
  std::string systems = default_systems();
};

/// The question with its numbers as C writes them in hexadecimal.
std::string in_hexadecimal(const std::string& question) {
  std::string text;
  std::istringstream lines(question);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string shown;
    for (std::string word; words >> word;) {
      const auto number = io::read_finite(word);
      shown += fmt::format("{}{}", shown.empty() ? "" : " ", number ? fmt::format("{:a}", *number) : word);
    }
    text += shown + "\n";
  }
  return text;
}

Finding finding_of(SuiteCase of, std::size_t ray, const Ask& ask, const Profile& profile) {
  of.the_case.rays = {of.the_case.rays[ray]};
  of.truths = {of.truths[ray]};
  const Claim claim = ask(of);
  const Judgement judgement = judge(of, 0, claim, profile);
  return {std::move(of), ray, claim, judgement};
}

std::string sentence(const Finding& finding) {
  return fmt::format("{}: expected {}; got {}\n", name(finding.judgement.verdict), truth_words(finding),
                     claim_words(finding));
}

int run(const Options& options) {
  const System system = find_system(options.system, options.systems, default_setups());
  if (const std::string why = why_absent(system); !why.empty())
    throw std::runtime_error(
        fmt::format("{} is absent: {}; expected durero conform setup {}", system.name, why, system.name));
  SuiteOptions suite = suite_of(options.of.suite);
  suite.tipos = system.profile.tipos;
  suite.caps = system.profile.caps;
  const Ask ask = asking(system, {}, interrupted());
  const Finding found = finding_of(case_of(options.of, suite), options.of.ray, ask, system.profile);
  fmt::print("{}", sentence(found));
  if (!is_failure(found.judgement.verdict)) return 0;
  const Finding least = minimised(found, system.profile, ask);
  constexpr std::array<std::size_t, 1> only{0};
  const std::string question = question_text(least.of, system.profile.caps, only);
  fmt::print("\n{}{}\nin hexadecimal:\n{}\n{}", sentence(least), question, in_hexadecimal(question),
             explanation(least.of, 0));
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
