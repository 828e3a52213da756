#pragma once
/// What the shards of a campaign say together, for people.

#include <string>
#include <vector>

#include "durero/conform/shard.hpp"
#include "durero/conform/system_file.hpp"

namespace durero::conform {

/// What all shards have together, with the worst ray of each family and verdict made and judged again. Of shards of one
/// number the first in the order of ShardCounts counts. Throws std::runtime_error where a ray is judged otherwise than
/// it was in its shard.
Tally totals(const Shards& shards, const Campaign& campaign, const Profile& profile);

/// The numbers of the shards that were given with different contents, ascending.
std::vector<std::uint64_t> disputed(const Shards& shards);

/// A bound on the share of rays that fail, where none of `judged` rays did: with more, so many rays would have shown a
/// failure in 95 of 100 campaigns. Precondition: judged > 0.
///
/// Where a share p of the rays fails, none of n that are drawn one by one does with probability (1 − p)ⁿ. That is 0.05
/// or more only where p ≤ 1 − 0.05^(1/n) = 1 − exp(−ln 20 / n) ≤ ln 20 / n < 3/n, as 1 − exp(−x) ≤ x and ln 20 < 3.
double failing_share(std::uint64_t judged);
/// The same whatever the rays of a scene have to do with each other. So many rays are of judged/64 scenes at least, and
/// the scenes are drawn one by one; a scene shows no failure with probability 1 − p at most, where one of its rays is
/// judged: that is, as if it had that ray alone.
double failing_share_by_scenes(std::uint64_t judged);

/// Which shards are there and which are missing, those that are disputed, a row a family and the worst rays, as
/// report_text has them, and the bounds of the families without a failure.
std::string campaign_text(const Shards& shards, const Campaign& campaign, const std::string& identity,
                          const System& system);

}  // namespace durero::conform
