// durero conform run SYSTEM…: asks systems the rays of a suite.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <set>
#include <stdexcept>
#include <thread>

#include "conform.hpp"
#include "conform_suite.hpp"
#include "conform_system.hpp"
#include "description.hpp"
#include "durero/conform/ask/runner.hpp"
#include "durero/conform/ask/setup.hpp"
#include "durero/conform/campaign/campaign.hpp"
#include "durero/conform/report/causes.hpp"
#include "durero/conform/report/least_findings.hpp"
#include "durero/io/standard_output.hpp"
#include "interrupted.hpp"
#include "numbers.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

using namespace conform;

struct ConformRunOptions {
  std::vector<std::string> names;
  SuiteCall suite;
  std::string systems = default_systems();
  std::string profile, report;
  std::size_t jobs = std::max(1U, std::thread::hardware_concurrency()), memory = 0;
  double time = 10;
  bool goes_on = false, is_not_minimised = false, quiet = false;
  LeastLimits least{};
};

/// The cases of the suite for a profile, family after family.
struct Plan {
  SuiteOptions suite;
  std::vector<std::pair<const Family*, std::uint64_t>> places;

  Plan(const SuiteCall& call, const Profile& profile) : suite(suite_of(call, profile)) {
    if (suite.families.empty()) {
      for (const Family& family : families()) suite.families.push_back(&family);
    }
    for (const Family* family : suite.families) {
      for (std::uint64_t number = 0; number < cases(suite, *family); ++number) places.emplace_back(family, number);
    }
  }

  RunCases run_cases(const Profile& profile) const {
    const auto make = [this](std::size_t place) {
      SuiteCase made = suite_case(suite, *places[place].first, places[place].second);
      answer(made);
      ask_question(made, suite);
      return made;
    };
    return {places.size(), make, [&profile](const SuiteCase& of) { return CaseJudge(of, profile).outside(); }};
  }
};

/// The identity of a run: only a run with the same identity goes on with its claims.
std::string identity(const System& system, const ConformRunOptions& options) {
  return fmt::format(
      "durero {} conform run {}, {}, --seed {} --rays {}{} {} --timeout {} --memory {} {}", DURERO_VERSION, system.name,
      system.title, options.suite.seed, options.suite.rays,
      options.suite.faces == usual_faces ? "" : fmt::format(" --faces {}", options.suite.faces),
      options.suite.question == SuiteCall().question ? "" : fmt::format(" --question {}", options.suite.question),
      options.time, options.memory, fmt::join(options.suite.families, " "));
}

AskOptions ask_options(const ConformRunOptions& options) {
  return {.time = std::chrono::duration<double>(options.time), .memory = std::uint64_t{options.memory} << 20U};
}

RunOptions run_options(const System& system, const ConformRunOptions& options) {
  RunOptions run{.ask = ask_options(options)};
  run.jobs = options.jobs;
  run.identity = identity(system, options);
  if (options.report.empty()) return run;
  std::filesystem::create_directories(options.report);
  run.claims = fmt::format("{}/{}.claims.jsonl", options.report, system.name);
  run.goes_on = options.goes_on && std::filesystem::exists(run.claims);
  return run;
}

/// The outcome for a system; its number is the exit status.
enum class ConformanceStatus { conformant = 0, not_conformant = 1, not_asked = 2 };

/// Asks the system and judges its claims; nothing where the run was stopped.
std::optional<Report> report_of(const System& system, const std::string& asked, const ConformRunOptions& options) {
  const Plan plan(options.suite, system.profile);
  Report report{.title = system.title,
                .asked = words_of_system(asked, options.profile),
                .profile = system.profile,
                .options = plan.suite};
  RunEnd end;
  {
    Progress progress(options.quiet, system.name, "scenes", plan.places.size());
    const auto sink = [&](const SuiteCase& of, std::span<const Claim> claims) {
      report.tally.add(of, claims, system.profile);
      progress.add();
    };
    end = run_system(system, plan.run_cases(system.profile), run_options(system, options), sink, interrupted());
  }
  report.version = end.says;
  if (!end.stopped) return report;
  io::print(fmt::format("{}: stopped after {} of {} scenes{}\n", system.name, end.cases, plan.places.size(),
                        options.report.empty() ? "" : "; --continue goes on"));
  return std::nullopt;
}

/// Makes the failures small for a report, and finds their causes: by asking again, if failures may be changed.
void explain(Report& report, const System& system, const ConformRunOptions& options) {
  if (report.tally.failures() == 0) return;
  if (options.is_not_minimised) return guess_causes(report);
  Progress progress(options.quiet, system.name + ": minimising", "questions");
  const Ask ask = counted(asking(system, ask_options(options), interrupted()), progress);
  if (!options.report.empty()) minimise_findings(report, ask, options.least);
  find_causes(report, ask, {});
  if (interrupted()) guess_causes(report);  // what was asked after the interrupt has no answer
}

ConformanceStatus run_one(const System& system, const std::string& asked, const ConformRunOptions& options) {
  if (const std::string why = why_absent(system); !why.empty()) {
    io::print(fmt::format("{}: absent: {}; expected durero conform setup {}\n", system.name, why, asked));
    return ConformanceStatus::not_asked;
  }
  const std::string folder = fmt::format("{}/{}", options.report, system.name);
  if (!options.report.empty()) require_room_for_reports(folder);
  std::optional<Report> report = report_of(system, asked, options);
  if (!report) return ConformanceStatus::not_asked;
  explain(*report, system, options);
  io::print(report_text(*report));
  if (!options.report.empty()) write_reports(folder, *report);
  return report->tally.is_conformant() ? ConformanceStatus::conformant : ConformanceStatus::not_conformant;
}

/// Checks that the names differ, for each system has a folder of its name for its findings.
void require_names_of_their_own(const std::vector<System>& systems) {
  std::set<std::string> names;
  for (const System& system : systems) {
    if (!names.insert(system.name).second)
      throw std::runtime_error(
          fmt::format("two systems are named {}; expected one of each name in a call with --report", system.name));
  }
}

int run(const ConformRunOptions& options) {
  require_use_of_profile(options.names, options.profile);
  std::vector<System> systems;
  for (const std::string& name : options.names) systems.push_back(system_of(name, options.profile, options.systems));
  if (!options.report.empty()) require_names_of_their_own(systems);
  int status = 0;
  for (std::size_t i = 0; i < systems.size(); ++i)
    status = std::max(status, static_cast<int>(run_one(systems[i], options.names[i], options)));
  return status;
}

void add_amounts(CLI::App& command, ConformRunOptions& options) {
  command
      .add_option("--jobs", options.jobs,
                  "So many processes of a system are asked at once; without it, as many as the machine has cores")
      ->check(whole_number(1, 256));
  command.add_option("--timeout", options.time, "Seconds that a ray may take")
      ->check(number(0.001, 86400))
      ->capture_default_str();
  command.add_option("--memory", options.memory, "MiB that a process of a system may take; 0: any")
      ->check(whole_number(0, 1 << 30))
      ->capture_default_str();
}

}  // namespace

void add_conform_run(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("run", "Ask systems the rays of a suite, and judge what they answer");
  const auto options = std::make_shared<ConformRunOptions>();
  command->add_option("SYSTEM", options->names, "Names of systems, files of systems, or command:PROGRAM")->required();
  add_rays(*command, options->suite);
  add_question(*command, options->suite.question);
  add_amounts(*command, *options);
  add_systems(*command, options->systems);
  command->add_option("--profile", options->profile, profile_help);
  auto* report =
      command->add_option("--report", options->report,
                          "The folder for the claims, and for what is found: a folder of the system's name in it");
  command->add_flag("--continue", options->goes_on, "Go on where the run of that folder was stopped")->needs(report);
  command->add_flag("--no-minimise", options->is_not_minimised, "The report shows failures as they were found")
      ->needs(report);
  add_quiet(*command, options->quiet);
  command->footer(
      "A system is asked in processes of its own: what crashes it or lets it hang costs one ray. What is found "
      "depends\n"
      "neither on --jobs nor on where a run was stopped.\n\n" +
      exit_status("all systems are right", "one is not, or no ray of it was judged",
                  "one is absent or was stopped, or the call is bad") +
      examples({"conform run embree --rays 10000 --report found",
                "conform run 'command:./my-tracer' --profile my-profile.json"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
