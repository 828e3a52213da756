#include "conform_campaign.hpp"

#include <filesystem>

#include "conform.hpp"
#include "conform_system.hpp"
#include "durero/io/file_name.hpp"

namespace durero::cli {
namespace {

/// The path of a file that a campaign names, from the campaign's folder; a system's name stays as it is.
std::string beside(const std::string& campaign, const std::string& name_or_file) {
  if (name_or_file.find('/') == name_or_file.npos && !io::ends_in(name_or_file, ".json")) return name_or_file;
  return std::filesystem::path(campaign).parent_path() / name_or_file;
}

}  // namespace

void add_campaign(CLI::App& command, CampaignCall& call) {
  command.add_option("CAMPAIGN", call.file, "The campaign: a file, as docs/campaigns.md has it")->required();
  add_systems(command, call.systems);
}

NamedCampaign campaign_of(const CampaignCall& call) {
  conform::Campaign campaign = conform::read_campaign(io::read_source(call.file));
  const bool is_command = campaign.system.starts_with(conform::of_command);
  const std::string name = is_command ? campaign.system : beside(call.file, campaign.system);
  conform::System system = system_of(name, beside(call.file, campaign.profile), call.systems);
  std::string identity = conform::identity(campaign, system.profile);
  return {std::move(campaign), std::move(system), std::move(identity)};
}

}  // namespace durero::cli
