#pragma once
/// The campaign that a call names, and its system.

#include <CLI/CLI.hpp>
#include <string>

#include "durero/conform/campaign.hpp"
#include "durero/conform/system_file.hpp"

namespace durero::cli {

struct CampaignCall {
  std::string file;
  std::string systems = conform::default_systems();
};

/// CAMPAIGN and --systems.
void add_campaign(CLI::App& command, CampaignCall& call);

struct NamedCampaign {
  conform::Campaign campaign;
  conform::System system;
  std::string identity;
};

/// Throws std::runtime_error where the campaign or its system is none.
NamedCampaign campaign_of(const CampaignCall& call);

}  // namespace durero::cli
