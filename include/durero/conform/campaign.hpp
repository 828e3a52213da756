#pragma once
/// Campaigns: one system, and so many rays that they are asked in shards, on as many machines as there are. A campaign
/// is a file:
///
///   {"format":"durero-campaign","version":1,"system":"embree","seed":1,"rays_of_a_shard":1048576,"shards":1000,
///    "families":["generic","tiny"],"types":["esfera"],"solids":false,"numbers":"binary32","time":10}
///
/// The keys up to `shards` must be there. Without `families` it asks all; without `types` and `solids` what the profile
/// of the system says. `system` is a name, a system's file, or `command:PROGRAM`, whose `profile` is then a key too.
/// Files are looked for from the campaign's own folder.
///
/// The rays of a shard are split evenly over the families. Of a family that has k cases in a shard, shard N has the
/// cases N·k … N·k + k − 1 of the suite that has the seed. So no ray is in two shards, the first shards of a campaign
/// are those of any longer one, and `durero conform show` makes each ray again.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "durero/conform/profile.hpp"
#include "durero/conform/suite.hpp"
#include "durero/io/source.hpp"

namespace durero::conform {

/// What a campaign asks of which system, as its file says it.
struct Campaign {
  std::string system;                               ///< a name, a system's file or command:PROGRAM
  std::string profile{};                            ///< of command:PROGRAM alone
  std::uint64_t seed = 1;                           ///< of the suite that its cases are of
  std::uint64_t rays_of_a_shard = 0;                ///< 0: shards that ask nothing, to try what runs them
  std::uint64_t shards = 1;                         ///< how many: they are numbered from 0
  std::vector<const Family*> families{};            ///< one at least, in the order of families()
  std::optional<std::vector<model::Tipo>> tipos{};  ///< none: those of the profile
  std::optional<Caps> caps{};                       ///< none: those of the profile
  Format numbers = Format::binary32;                ///< of scenes, but for discs that close solids, and of rays
  double time = 10;                                 ///< seconds, for a ray
};

/// How a system that is no name but a program is given.
inline constexpr std::string_view of_command = "command:";

/// Throws io::InputError.
Campaign read_campaign(const io::Source& source);

/// What names a campaign: a digest of its members, of the format of suites, and of what its system claims, for that
/// decides the verdicts. Who writes a campaign in another way, with its keys in another order, writes the same; and so
/// does who makes it longer, for the shards that are there stay what they are.
std::string identity(const Campaign& campaign, const Profile& profile);

/// The suite that has the campaign's cases, but for its number of rays.
SuiteOptions suite_options(const Campaign& campaign, const Profile& profile);

/// A case of a shard.
struct CasePlace {
  const Family* family = nullptr;  ///< one of the campaign's
  std::uint64_t number = 0;        ///< among the cases of its family
  std::size_t rays = 0;            ///< how many it has, rays_of_a_case at most
  bool operator==(const CasePlace&) const = default;
};

/// The cases of a shard, family after family; none of a family that has no scene of the suite's types. Precondition:
/// shard < campaign.shards.
std::vector<CasePlace> cases_of_shard(const Campaign& campaign, const SuiteOptions& options, std::uint64_t shard);

/// The case, without its truths.
SuiteCase suite_case(SuiteOptions options, const CasePlace& place);

}  // namespace durero::conform
