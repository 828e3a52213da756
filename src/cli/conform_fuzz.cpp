// durero conform fuzz SYSTEM --minutes N: a search for questions about which a system is wrong.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <optional>

#include "conform.hpp"
#include "conform_suite.hpp"
#include "conform_system.hpp"
#include "description.hpp"
#include "durero/conform/report/fuzz_report.hpp"
#include "durero/io/standard_output.hpp"
#include "interrupted.hpp"
#include "numbers.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

using namespace conform;

struct ConformFuzzOptions {
  SystemCall system;
  SuiteCall suite{.faces = fuzzed_faces};
  std::string report;
  std::uint64_t steps = 0;
  double minutes = 1;
  double time = 10;
  bool has_minutes = false, quiet = false;
};

/// The call that finds the same again in so many steps.
std::string call_again(const ConformFuzzOptions& options, std::uint64_t steps) {
  std::string call =
      fmt::format("durero conform fuzz {} --seed {} --steps {}",
                  words_of_system(options.system.system, options.system.profile), options.suite.seed, steps);
  if (!options.suite.families.empty()) call += fmt::format(" --family {}", fmt::join(options.suite.families, ","));
  if (options.suite.faces != fuzzed_faces) call += fmt::format(" --faces {}", options.suite.faces);
  if (options.suite.question != SuiteCall().question) call += fmt::format(" --question {}", options.suite.question);
  if (options.suite.numbers != SuiteCall().numbers) call += fmt::format(" --numbers {}", options.suite.numbers);
  return call;
}

Fuzzing search(const ConformFuzzOptions& options, const System& system, const Ask& ask) {
  using Clock = std::chrono::steady_clock;
  const bool is_timed = options.has_minutes || options.steps == 0;
  const auto end = Clock::now() + std::chrono::duration<double>(60 * options.minutes);
  Progress progress(options.quiet, system.name, "questions", options.steps);
  const auto goes_on = [&] { return !interrupted() && !(is_timed && Clock::now() >= end); };
  const FuzzOptions fuzzing{.suite = suite_of(options.suite, system.profile), .steps = options.steps};
  return fuzz(fuzzing, system.profile, counted(ask, progress), goes_on);
}

/// The folder of the system's name in that of the option; empty without one.
std::string folder_of(const ConformFuzzOptions& options, const System& system) {
  return options.report.empty() ? "" : fmt::format("{}/{}", options.report, system.name);
}

int run(const ConformFuzzOptions& options) {
  const System system = system_of(options.system);
  require_present(system);
  const std::string folder = folder_of(options, system);
  if (!folder.empty()) require_room_for_reports(folder);
  FuzzReport report{.title = system.title, .seed = options.suite.seed, .profile = system.profile};
  const AskOptions asked{.time = std::chrono::duration<double>(options.time)};
  const Ask ask = asking(system, asked, interrupted(), &report.version);
  report.fuzzing = search(options, system, ask);
  report.is_stopped = interrupted();
  report.call = call_again(options, report.fuzzing.steps);
  if (report.is_stopped) {
    report.causes = guessed_causes(report.fuzzing, system.profile);
  } else {
    Progress progress(options.quiet, system.name + ": minimising", "questions");
    report.causes = fuzzed_causes(report.fuzzing, system.profile, counted(ask, progress), {});
  }
  io::print(fuzz_text(report));
  if (!folder.empty()) write_fuzz_report(folder, report);
  return report.fuzzing.failures > 0 ? 1 : 0;
}

}  // namespace

void add_conform_fuzz(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("fuzz", "Search for questions about which a system is wrong");
  const auto options = std::make_shared<ConformFuzzOptions>();
  add_system(*command, options->system);
  auto* minutes = command->add_option("--minutes", options->minutes, "So long it searches, before it makes small")
                      ->check(number(0.001, 100'000))
                      ->capture_default_str();
  command->add_option("--steps", options->steps, "So many questions it makes; then --minutes counts only where given")
      ->check(whole_number(1, std::uint64_t{1} << 53U));
  add_sources(*command, options->suite);
  add_question(*command, options->suite.question);
  command->add_option("--timeout", options->time, "Seconds that a ray may take")
      ->check(number(0.001, 86400))
      ->capture_default_str();
  command->add_option("--report", options->report,
                      "The folder for what is found, in a folder of the system's name: search.json and search.html");
  add_quiet(*command, options->quiet);
  command->footer(
      "Questions of the families are changed at random, again and again, towards new places and larger errors. The\n"
      "seed and the steps find the same again. An interrupt ends the search and keeps what was found.\n\n" +
      exit_status("the system was right about all", "it was not", "the system is absent, or the call is bad") +
      examples({"conform fuzz embree --minutes 5",
                "conform fuzz 'command:./my-tracer' --profile my-profile.json --steps 20000 --report found"}));
  command->callback([options, minutes, &status] {
    options->has_minutes = minutes->count() > 0;
    status = run(*options);
  });
}

}  // namespace durero::cli
