#include "durero/conform/campaign/campaign_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "conform/families/digest.hpp"
#include "conform/report/report_parts.hpp"
#include "durero/conform/ask/question.hpp"

namespace durero::conform {
namespace {

constexpr std::size_t shown_ranges = 100;

/// The shards that count: the first of each number.
std::vector<const ShardCounts*> counting(const Shards& shards) {
  std::vector<const ShardCounts*> first;
  for (const ShardCounts& counts : shards.counts) {
    if (first.empty() || first.back()->shard != counts.shard) first.push_back(&counts);
  }
  return first;
}

template <std::size_t size>
void add(std::array<std::uint64_t, size>& sums, const std::vector<std::uint64_t>& counts) {
  for (std::size_t i = 0; i < counts.size(); ++i) sums[i] += counts[i];
}

void add(FamilyTally& tally, const FamilyCounts& counts, const std::vector<std::string>& clauses) {
  add(tally.counts, counts.verdicts);
  for (std::size_t i = 0; i < counts.clauses.size(); ++i) {
    tally.clauses[clauses[i]] += counts.clauses[i];
    tally.counts[static_cast<std::size_t>(Verdict::skipped)] += counts.clauses[i];
  }
}

Claim claim_of(const FailedRay& failed, const SuiteCase& of) {
  try {
    return read_claim(failed.claim, of.the_case.scene);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(fmt::format("{} ray {}: {}; expected a claim on it", of.name(), failed.ray, error.what()));
  }
}

/// The finding of a failed ray, which is made and judged again.
Finding finding_of(const FailedRay& failed, const Family& family, Verdict verdict, const SuiteOptions& options,
                   const Profile& profile) {
  SuiteCase of = suite_case(options, {&family, failed.number, failed.ray + 1});
  of = with_ray_alone(of, failed.ray);
  const Claim claim = claim_of(failed, of);
  const ClaimJudgement is = judge(of, 0, claim, profile);
  if (is.verdict != verdict)
    throw std::runtime_error(
        fmt::format("{} ray {} was judged {} and is {} now; expected shards of a program that judges as this one does",
                    of.name(), failed.ray, name(verdict), name(is.verdict)));
  return {std::move(of), failed.ray, claim, is};
}

std::string range_text(std::uint64_t begin, std::uint64_t end) {
  return end - begin == 1 ? fmt::format("{}", begin) : fmt::format("{}-{}", begin, end - 1);
}

/// The missing shards as a line, `missing: 17, 40-41`; empty where none is missing.
std::string missing_text(const std::vector<const ShardCounts*>& there, std::uint64_t shards) {
  std::string text;
  std::size_t ranges = 0;
  std::uint64_t next = 0, unshown = 0;
  const auto pass = [&](std::uint64_t end) {
    if (end > next && ranges++ >= shown_ranges)
      unshown += end - next;
    else if (end > next)
      text += fmt::format("{}{}", text.empty() ? "missing: " : ", ", range_text(next, end));
    next = end + 1;
  };
  for (const ShardCounts* counts : there) pass(counts->shard);
  pass(shards);
  if (unshown > 0) text += fmt::format(" and {} more", unshown);
  return text.empty() ? text : text + "\n";
}

std::string disputes_text(const Shards& shards) {
  std::string text;
  for (const std::uint64_t shard : disputed(shards)) {
    text += fmt::format("shard {} was given with different contents:", shard);
    const ShardCounts least{.shard = shard};
    for (auto of = shards.counts.lower_bound(least); of != shards.counts.end() && of->shard == shard; ++of)
      text += fmt::format(" answers {}", digest_text(of->answers));
    text += "; the first counts. The system is not deterministic, or a machine is broken\n";
  }
  return text;
}

/// The histogram of ulps in words: `hits off by 0 ulps: 850, up to 1: 90, up to 2: 60`.
std::string ulps_text(const std::vector<const ShardCounts*>& there) {
  std::array<std::uint64_t, ulp_bins> sums{};
  for (const ShardCounts* counts : there) add(sums, counts->ulps);
  std::string text = fmt::format("hits off by 0 ulps: {}", sums[0]);
  for (std::size_t bin = 1; bin < ulp_bins; ++bin) {
    if (sums[bin] == 0) continue;
    const std::string last = fmt::format(", up to {}: ", std::uint64_t{1} << std::min<std::size_t>(bin - 1, 63));
    text += (bin == ulp_bins - 1 ? ", more: " : last) + fmt::format("{}", sums[bin]);
  }
  return text + "\n";
}

/// A row of the bounds on failing rays; empty where no ray was judged or one failed.
template <class Counts>
std::string bound_row(std::string_view title, const Counts& of, std::size_t of_scene) {
  const std::uint64_t judged = of.rays() - of.of(Verdict::skipped);
  if (judged == 0 || of.failures() > 0) return "";
  return fmt::format("{:<20}{:>15}{:>15.2g}{:>15.2g}\n", title, judged, failing_share(judged),
                     failing_share_by_scenes(judged, of_scene));
}

std::string bounds_text(const Tally& tally) {
  std::string rows;
  std::size_t most = rays_of_a_case;
  for (const FamilyTally& family : tally.families()) {
    most = std::max(most, rays_of(*family.family));
    rows += bound_row(family.family->name, family, rays_of(*family.family));
  }
  rows += bound_row("all", tally, most);
  if (rows.empty()) return rows;
  const std::string of_meshes = most == rays_of_a_case ? "" : fmt::format(", {}/n with meshes,", 3 * most);
  return fmt::format(
             "\n95 %: where none of n judged rays failed, at most 3/n of such rays do, and {}/n{} where rays of a "
             "scene fail together\n{:<20}{:>15}{:>15}{:>15}\n",
             3 * rays_of_a_case, of_meshes, "family", "n", "3/n", fmt::format("{}/n", 3 * rays_of_a_case)) +
         rows;
}

/// The system's name, where `durero conform minimise` makes the campaign's cases: those of its profile.
std::string asked_by_name(const Campaign& campaign, const System& system) {
  const bool is_usual =
      !campaign.tipos && !campaign.caps && campaign.numbers == SuiteOptions().numbers && campaign.faces == usual_faces;
  return is_usual && system.name == campaign.system ? system.name : "";
}

}  // namespace

Tally totals(const Shards& shards, const Campaign& campaign, const Profile& profile) {
  std::vector<FamilyTally> tallies;
  for (const Family* family : campaign.families) tallies.push_back({.family = family});
  for (const ShardCounts* counts : counting(shards)) {
    for (std::size_t i = 0; i < counts->families.size(); ++i) add(tallies[i], counts->families[i], counts->clauses);
  }
  const SuiteOptions options = suite_options(campaign, profile);
  for (const auto& [kind, failed] : shards.failures) {
    const auto& [family, verdict] = kind;
    FamilyTally& tally = *std::ranges::find(tallies, family, &FamilyTally::family);
    tally.worst[static_cast<std::size_t>(verdict)] = finding_of(failed.worst(), *family, verdict, options, profile);
  }
  return Tally(std::move(tallies));
}

std::vector<std::uint64_t> disputed(const Shards& shards) {
  std::vector<std::uint64_t> numbers;
  const ShardCounts* before = nullptr;
  for (const ShardCounts& counts : shards.counts) {
    const bool is_again = before != nullptr && before->shard == counts.shard;
    if (is_again && (numbers.empty() || numbers.back() != counts.shard)) numbers.push_back(counts.shard);
    before = &counts;
  }
  return numbers;
}

double failing_share(std::uint64_t judged) { return std::min(1.0, 3 / static_cast<double>(judged)); }
double failing_share_by_scenes(std::uint64_t judged, std::size_t of_scene) {
  return std::min(1.0, 3.0 * static_cast<double>(of_scene) / static_cast<double>(judged));
}

Report campaign_report(const Shards& shards, const Campaign& campaign, const System& system) {
  return {.title = system.title,
          .version = shards.says,
          .asked = asked_by_name(campaign, system),
          .profile = system.profile,
          .options = suite_options(campaign, system.profile),
          .tally = totals(shards, campaign, system.profile)};
}

std::string campaign_text(const Shards& shards, const Campaign& campaign, const std::string& identity,
                          const System& system) {
  const std::vector<const ShardCounts*> there = counting(shards);
  const Report report = campaign_report(shards, campaign, system);
  return fmt::format("campaign {}: {} of {} shards\n", identity, there.size(), campaign.shards) +
         missing_text(there, campaign.shards) + disputes_text(shards) + report_text(report) + "\n" + ulps_text(there) +
         bounds_text(report.tally);
}

}  // namespace durero::conform
