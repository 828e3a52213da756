#pragma once
/// The report on a campaign sums up its shards for people.

#include <string>
#include <vector>

#include "durero/conform/ask/system_file.hpp"
#include "durero/conform/campaign/shard.hpp"
#include "durero/conform/report/report.hpp"

namespace durero::conform {

/// The tally of all shards together; the worst ray of each family and verdict is made and judged again. Where shards
/// share a number, the first in the order of ShardCounts counts. Throws std::runtime_error where a ray is judged
/// otherwise than in its shard.
Tally totals(const Shards& shards, const Campaign& campaign, const Profile& profile);

/// The numbers of the shards that were given with different contents, ascending.
std::vector<std::uint64_t> disputed(const Shards& shards);

/// A bound on the share of rays that fail, where none of `judged` rays did: with more, so many rays would have shown a
/// failure in 95 of 100 campaigns. Precondition: judged > 0.
///
/// Where a share p of the rays fails, none of n that are drawn one by one does with probability (1 − p)ⁿ. That is 0.05
/// or more only where p ≤ 1 − 0.05^(1/n) = 1 − exp(−ln 20 / n) ≤ ln 20 / n < 3/n, as 1 − exp(−x) ≤ x and ln 20 < 3.
double failing_share(std::uint64_t judged);
/// A bound like failing_share() that holds however the rays of a scene depend on each other. `judged` rays come from
/// judged/of_scene scenes at least, which have so many rays at most, and the scenes are drawn one by one. A scene where
/// one ray is judged shows no failure with probability 1 − p at most: that is, as if it had that ray alone.
/// Precondition: judged > 0.
double failing_share_by_scenes(std::uint64_t judged, std::size_t of_scene = rays_of_a_case);

/// The report of all shards together, as of one run: the worst rays are those of totals(), and what only a run keeps,
/// such as its dots and samples, is left out. Throws what totals() throws.
Report campaign_report(const Shards& shards, const Campaign& campaign, const System& system);

/// The report in words: the shards that are there, missing or disputed; a row for each family and the worst rays, as
/// report_text has them; and the bounds of the families without a failure.
std::string campaign_text(const Shards& shards, const Campaign& campaign, const std::string& identity,
                          const System& system);

}  // namespace durero::conform
