#pragma once
/// The campaign that a call names, and its system.

#include <CLI/CLI.hpp>
#include <string>

#include "durero/conform/ask/system_file.hpp"
#include "durero/conform/campaign/campaign.hpp"

namespace durero::cli {

struct CampaignCall {
  std::string file;
  std::string systems = conform::default_systems();
};

/// Adds the argument CAMPAIGN and the option --systems.
void add_campaign(CLI::App& command, CampaignCall& call);

struct NamedCampaign {
  conform::Campaign campaign;
  conform::System system;
  std::string identity;
};

/// The campaign of the call, and its system. Throws std::runtime_error where there is no such campaign or system.
NamedCampaign campaign_of(const CampaignCall& call);

}  // namespace durero::cli
