#pragma once
/// A campaign asks one system so many rays that they are split into shards, for as many machines as there are. A
/// campaign is a file:
///
///   {"format":"durero-campaign","version":1,"system":"embree","seed":1,"rays_of_a_shard":1048576,"shards":1000,
///    "families":["generic","tiny"],"types":["esfera"],"solids":false,"numbers":"binary32","time":10,
///    "question":"first"}
///
/// The keys up to `shards` are required. Without `families` a campaign asks all; without `types` and `solids` those of
/// the system's profile. `system` is a name, a system's file, or `command:PROGRAM`, which needs the key `profile` too.
/// Relative file names start from the campaign's own folder.
///
/// The rays of a shard are split evenly over the families. Where a family has k cases in a shard, shard N has the cases
/// N·k … N·k + k − 1 of the suite that has the seed. No ray is in two shards, therefore; the first shards of a campaign
/// are those of any longer one; and `durero conform show` makes each ray again.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "durero/conform/ask/profile.hpp"
#include "durero/conform/families/suite.hpp"
#include "durero/io/source.hpp"

namespace durero::conform {

/// The plan of a campaign, as its file gives it.
struct Campaign {
  std::string system;                               ///< a name, a system's file or command:PROGRAM
  std::string profile{};                            ///< the profile, for command:PROGRAM alone
  std::uint64_t seed = 1;                           ///< the seed of the suite that has its cases
  std::uint64_t rays_of_a_shard = 0;                ///< 0: shards that ask nothing, to try the machines
  std::uint64_t shards = 1;                         ///< the number of shards, which are numbered from 0
  std::vector<const Family*> families{};            ///< one at least, in the order of families()
  std::optional<std::vector<model::Tipo>> tipos{};  ///< none: those of the profile
  std::optional<std::vector<BodyKind>> bodies{};    ///< likewise
  std::optional<Caps> caps{};                       ///< none: those of the profile
  NumberFormat numbers = NumberFormat::binary32;    ///< the format of scenes and rays, except discs that close solids
  double time = 10;                                 ///< seconds for each ray
  std::size_t faces = usual_faces;                  ///< about so many faces has a mesh
  QuestionKind question = QuestionKind::first;      ///< the question about the rays
};

/// The prefix of a system that is given as a program.
inline constexpr std::string_view of_command = "command:";

/// Reads a campaign. Throws io::InputError.
Campaign read_campaign(const io::Source& source);

/// The identity of a campaign: a digest of its members except the number of shards, of the format of suites, and of its
/// system's profile, which decides the verdicts. Neither the order of keys in the file nor a later extension by more
/// shards changes it: the shards that are there stay what they are.
std::string identity(const Campaign& campaign, const Profile& profile);

/// The options of the suite that has the campaign's cases; only its number of rays is another. Throws
/// std::runtime_error where the profile does not claim the question.
SuiteOptions suite_options(const Campaign& campaign, const Profile& profile);

/// A case of a shard.
struct CasePlace {
  const Family* family = nullptr;  ///< one of the campaign's families
  std::uint64_t number = 0;        ///< its number among the cases of its family
  std::size_t rays = 0;            ///< the number of its rays, rays_of(family) at most
  bool operator==(const CasePlace&) const = default;
};

/// The cases of a shard, family after family; none of a family that has no scene of the suite's types. Precondition:
/// shard < campaign.shards.
std::vector<CasePlace> cases_of_shard(const Campaign& campaign, const SuiteOptions& options, std::uint64_t shard);

/// The case at this place, answered to the question of the options.
SuiteCase suite_case(SuiteOptions options, const CasePlace& place);

}  // namespace durero::conform
