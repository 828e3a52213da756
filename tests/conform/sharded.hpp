#pragma once
/// Shards of a campaign on a system that is a function of this program.

#include <string>

#include "conform/judged.hpp"
#include "durero/conform/campaign/shard.hpp"

namespace durero::test {

/// What a system that claims so gets in a shard, and says of itself.
inline conform::Shards shard_of(const conform::Campaign& campaign, std::uint64_t number,
                                conform::Claims (*claims)(const conform::SuiteCase&), const std::string& says) {
  const conform::Profile profile = profile_of_all();
  conform::ShardTally tally(campaign, number, profile);
  const conform::SuiteOptions options = suite_options(campaign, profile);
  for (const conform::CasePlace& place : cases_of_shard(campaign, options, number)) {
    conform::SuiteCase of = suite_case(options, place);
    answer(of);
    tally.add(of, claims(of));
  }
  return tally.shards(says);
}

}  // namespace durero::test
