// durero conform shard CAMPAIGN N: asks the system of a campaign the rays of one of its shards.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>

#include "conform.hpp"
#include "conform_campaign.hpp"
#include "conform_system.hpp"
#include "description.hpp"
#include "durero/conform/ask/runner.hpp"
#include "durero/conform/campaign/shard.hpp"
#include "durero/io/output_file.hpp"
#include "interrupted.hpp"
#include "numbers.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

using namespace conform;

struct ConformShardOptions {
  CampaignCall campaign;
  std::uint64_t shard = 0;
  std::string output;
  std::size_t jobs = std::max(1U, std::thread::hardware_concurrency()), memory = 0;
  std::optional<double> time;
  bool quiet = false;
};

RunCases run_cases(const std::vector<CasePlace>& places, const SuiteOptions& suite, const Profile& profile) {
  const auto make = [&](std::size_t place) { return suite_case(suite, places[place]); };
  return {places.size(), make, [&](const SuiteCase& of) { return CaseJudge(of, profile).outside(); }};
}

Shards asked(const NamedCampaign& named, const ConformShardOptions& options) {
  const auto& [campaign, system, identity] = named;
  const SuiteOptions suite = suite_options(campaign, system.profile);
  const std::vector<CasePlace> places = cases_of_shard(campaign, suite, options.shard);
  ShardTally tally(campaign, options.shard, system.profile);
  RunOptions run{.jobs = options.jobs};
  run.ask.time = std::chrono::duration<double>(options.time.value_or(campaign.time));
  run.ask.memory = std::uint64_t{options.memory} << 20U;
  Progress progress(options.quiet, fmt::format("{}, shard {}", system.name, options.shard), "scenes", places.size());
  const auto sink = [&](const SuiteCase& of, std::span<const Claim> claims) {
    tally.add(of, claims);
    progress.add();
  };
  const RunEnd end = run_system(system, run_cases(places, suite, system.profile), run, sink, interrupted());
  if (end.stopped)
    throw std::runtime_error(
        fmt::format("shard {}: stopped after {} of {} scenes; expected to go on, and nothing was written",
                    options.shard, end.cases, places.size()));
  return tally.shards(end.says);
}

int run(const ConformShardOptions& options) {
  const NamedCampaign named = campaign_of(options.campaign);
  if (options.shard >= named.campaign.shards)
    throw std::runtime_error(
        fmt::format("no shard {}; expected one from 0 to {}", options.shard, named.campaign.shards - 1));
  require_present(named.system);
  const std::string path = options.output.empty() ? fmt::format("shard-{:07}.json", options.shard) : options.output;
  // A file that cannot be written is refused at once. It is not kept open for hours, for a killed process would leave
  // it behind.
  static_cast<void>(io::OutputFile(path));
  io::write_file(path, shards_text(asked(named, options), named.campaign, named.identity));
  return 0;
}

}  // namespace

void add_conform_shard(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("shard", "Ask the system of a campaign the rays of one shard");
  const auto options = std::make_shared<ConformShardOptions>();
  add_campaign(*command, options->campaign);
  command->add_option("N", options->shard, "Which shard, from 0")
      ->check(whole_number(0, std::uint64_t{1} << 53U))
      ->required();
  command->add_option("--output", options->output, "The file to write; without it, shard-000000N.json here");
  command
      ->add_option("--jobs", options->jobs,
                   "So many processes of the system are asked at once; without it, as many as the machine has cores")
      ->check(whole_number(1, 256));
  command->add_option("--time", options->time, "Seconds that a ray may take; without it, what the campaign says")
      ->check(number(0.001, 86400));
  command->add_option("--memory", options->memory, "MiB that a process of the system may take; 0: any")
      ->check(whole_number(0, 1 << 30))
      ->capture_default_str();
  add_quiet(*command, options->quiet);
  command->footer(
      "The file depends on the campaign, on N and on what the system answers; it is whole or not there. What crashes "
      "the\n"
      "system or lets it hang costs one ray.\n\n" +
      exit_status("it is written, whether the system is right or not",
                  "the system is absent or was stopped, or the call is bad") +
      examples({"conform shard campaign.json 0"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
