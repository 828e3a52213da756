#include "durero/conform/campaign/shard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

#include "conform/campaign/trimmed.hpp"
#include "conform/families/digest.hpp"
#include "conform/families/scattered.hpp"
#include "durero/conform/ask/question.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {
namespace {

/// The length in bytes up to which a clause is counted apart.
constexpr std::size_t longest_clause = 200;

/// The hash of a ray. A case has rays_of_a_mesh rays at most, so no two rays of a family have the same number here, and
/// scattered() is a bijection.
std::uint64_t hash(const FailedRay& ray) { return scattered(ray.number * rays_of_a_mesh + ray.ray); }

/// Whether ray a is worse than b: farther from the surface, then easier to read, then earlier.
bool is_worse(const FailedRay& a, const FailedRay& b) {
  return std::tie(b.backward, a.elements, a.number, a.ray, a.claim) <
         std::tie(a.backward, b.elements, b.number, b.ray, b.claim);
}

bool is_less(const FailedRay& a, const FailedRay& b) { return hash(a) != hash(b) ? hash(a) < hash(b) : a < b; }

/// The digest of an answer after the answers before it. It covers the content, but neither the words of a refusal nor
/// the way in which the system died.
std::uint64_t digest_of(const Claim& claim, std::uint64_t before) {
  std::string bytes(1, static_cast<char>(claim.outcome));
  const auto add = [&](std::uint64_t word) {
    for (unsigned shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(word >> shift & 0xffU);
  };
  if (claim.element) add(static_cast<std::uint64_t>(claim.element->tipo) << 32U | claim.element->index);
  bytes += claim.t ? 't' : '-';
  if (claim.t) add(std::bit_cast<std::uint64_t>(*claim.t));
  bytes += claim.punto ? 'p' : '-';
  if (claim.punto) {
    for (const double x : {claim.punto->x, claim.punto->y, claim.punto->z}) add(std::bit_cast<std::uint64_t>(x));
  }
  if (claim.count) add(*claim.count);
  std::uint64_t all = digest(bytes, before);
  for (const Claim& behind : claim.behind) all = digest_of(behind, all);
  return all;
}

std::vector<std::uint64_t> ulps_of(const Tally& tally) {
  std::vector<std::uint64_t> sums(ulp_bins);
  for (const FamilyTally& family : tally.families())
    std::ranges::transform(sums, family.ulps, sums.begin(), std::plus<>());
  return sums;
}

/// The clauses that are counted apart, ascending, with other_clauses where there are others.
std::vector<std::string> clauses_of(const Tally& tally) {
  std::map<std::string, std::uint64_t> counts;
  for (const FamilyTally& family : tally.families()) {
    for (const auto& [clause, count] : family.clauses)
      counts[clause.size() > longest_clause ? std::string(other_clauses) : clause] += count;
  }
  std::vector<std::pair<std::string, std::uint64_t>> most(counts.begin(), counts.end());
  std::ranges::stable_sort(most, std::greater<>(), &std::pair<std::string, std::uint64_t>::second);
  std::set<std::string> kept;
  for (const auto& [clause, count] : most)
    kept.insert(kept.size() < clauses_kept ? clause : std::string(other_clauses));
  return {kept.begin(), kept.end()};
}

FamilyCounts counts_of(const FamilyTally& tally, const std::vector<std::string>& clauses) {
  FamilyCounts counts{{tally.counts.begin(), tally.counts.end() - 1}, {}};
  counts.clauses.resize(clauses.size());
  for (const auto& [clause, count] : tally.clauses) {
    auto place = std::ranges::lower_bound(clauses, clause);
    if (place == clauses.end() || *place != clause) place = std::ranges::lower_bound(clauses, other_clauses);
    counts.clauses[static_cast<std::size_t>(place - clauses.begin())] += count;
  }
  return trimmed(std::move(counts));
}

}  // namespace

bool FailedRays::may_keep(const FailedRay& ray) const {
  return least_.size() < failures_kept || hash(ray) <= hash(least_.back()) || ray.backward >= worst_->backward;
}

void FailedRays::add(const FailedRay& ray) {
  if (!worst_ || is_worse(ray, *worst_)) worst_ = ray;
  const auto place = std::ranges::lower_bound(least_, ray, is_less);
  if (place != least_.end() && *place == ray) return;
  least_.insert(place, ray);
  if (least_.size() > failures_kept) least_.pop_back();
}

std::set<FailedRay> FailedRays::all() const {
  std::set<FailedRay> all(least_.begin(), least_.end());
  if (worst_) all.insert(*worst_);
  return all;
}

void unite(Shards& shards, Shards other) {
  if (shards.says.empty()) shards.says = other.says;
  if (!other.says.empty() && other.says != shards.says)
    throw std::invalid_argument(
        fmt::format("of {}; expected {}, as the others", text::shown(other.says), text::shown(shards.says)));
  shards.counts.merge(other.counts);
  for (const auto& [kind, rays] : other.failures) {
    for (const FailedRay& ray : rays.all()) shards.failures[kind].add(ray);
  }
}

void ShardTally::add(const SuiteCase& of, std::span<const Claim> claims) {
  const std::vector<ClaimJudgement> judgements = tally_.add(of, claims, *profile_);
  for (std::size_t ray = 0; ray < claims.size(); ++ray) {
    answers_ = digest_of(claims[ray], answers_);
    const ClaimJudgement& is = judgements[ray];
    if (!is_failure(is.verdict)) continue;
    const double backward = std::isnan(is.backward) ? std::numeric_limits<double>::infinity() : is.backward;
    FailedRay failed{of.number, ray, of.the_case.scene.size(), backward};
    FailedRays& kept = failures_[{of.family, is.verdict}];
    if (!kept.may_keep(failed)) continue;
    failed.claim = claim_text(claims[ray], of.the_case.scene);
    kept.add(failed);
  }
}

Shards ShardTally::shards(const std::string& says) const {
  ShardCounts counts{.shard = shard_, .answers = answers_, .ulps = ulps_of(tally_), .clauses = clauses_of(tally_)};
  for (const Family* family : campaign_->families) {
    const auto tally = std::ranges::find(tally_.families(), family, &FamilyTally::family);
    counts.families.push_back(tally == tally_.families().end() ? FamilyCounts{} : counts_of(*tally, counts.clauses));
  }
  return {says, {trimmed(std::move(counts))}, failures_};
}

}  // namespace durero::conform
