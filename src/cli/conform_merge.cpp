// durero conform merge CAMPAIGN PATH… [--output MERGED] [--report DIR]: what the shards of a campaign say together.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>

#include "conform.hpp"
#include "conform_campaign.hpp"
#include "description.hpp"
#include "durero/conform/campaign/campaign_report.hpp"
#include "durero/conform/report/causes.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/standard_output.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

using namespace conform;
namespace fs = std::filesystem;

struct ConformMergeOptions {
  CampaignCall campaign;
  std::vector<std::string> paths;
  std::string output, report;
  bool quiet = false;
};

bool is_campaign(const std::string& file) {
  try {
    read_campaign(io::read_source(file));
    return true;
  } catch (const io::InputError&) {
    return false;
  }
}

/// The file, or every .json of a folder but a campaign, such as the copy of one beside its shards; by name.
std::vector<std::string> files_of(const std::string& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(path)) {
    if (entry.path().extension() == ".json" && !is_campaign(entry.path())) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

void add_file(Shards& shards, const std::string& file, const NamedCampaign& named) {
  Shards read = read_shards(io::read_source(file), named.campaign, named.identity);
  try {
    unite(shards, std::move(read));
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(fmt::format("{}: {}", file, error.what()));
  }
}

int run(const ConformMergeOptions& options) {
  const NamedCampaign named = campaign_of(options.campaign);
  std::optional<io::OutputFile> output;
  if (!options.output.empty()) output.emplace(options.output);
  if (!options.report.empty()) require_room_for_reports(options.report);
  std::vector<std::string> files;
  for (const std::string& path : options.paths) std::ranges::copy(files_of(path), std::back_inserter(files));
  Shards shards;
  std::optional<Progress> progress(std::in_place, options.quiet, "merge", "files", files.size());
  for (const std::string& file : files) {
    add_file(shards, file, named);
    progress->add();
  }
  progress.reset();
  const std::string said = campaign_text(shards, named.campaign, named.identity, named.system);
  if (output) {
    output->write(shards_text(shards, named.campaign, named.identity));
    output->commit();
  }
  if (!options.report.empty()) {
    Report report = campaign_report(shards, named.campaign, named.system);
    guess_causes(report);
    write_reports(options.report, report);
  }
  io::print(said);
  return disputed(shards).empty() ? 0 : 1;
}

}  // namespace

void add_conform_merge(CLI::App& conform, int& status) {
  auto* command = conform.add_subcommand("merge", "Put shards of a campaign together, and say what they found");
  const auto options = std::make_shared<ConformMergeOptions>();
  add_campaign(*command, options->campaign);
  command->add_option("PATH", options->paths, "Files of shards, single or merged, and folders of them")->required();
  command->add_option("--output", options->output, "The file for all of them together");
  command->add_option("--report", options->report, "The folder for JSON, JUnit XML, SARIF and a page of HTML");
  add_quiet(*command, options->quiet);
  command->footer(
      "Shards may come in any order, again, and merged before: the file is the same. Of a folder every .json is "
      "taken,\n"
      "but a campaign. A file of another campaign or another version of the system, one that is truncated or "
      "altered,\n"
      "is refused.\n\n" +
      exit_status("they are put together, whatever they found", "a shard was given with different contents",
                  "a file was refused, or the call is bad") +
      examples({"conform merge campaign.json shards --output merged.json"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
