#include "durero/conform/report/tally.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace durero::conform {
namespace {

constexpr std::size_t place(Verdict verdict) { return static_cast<std::size_t>(verdict); }

template <class Holds>
std::uint64_t sum_where(const FamilyTally& tally, Holds holds) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < tally.counts.size(); ++i) {
    if (holds(static_cast<Verdict>(i))) sum += tally.counts[i];
  }
  return sum;
}

template <class Count>
std::uint64_t sum_of(const std::vector<FamilyTally>& families, Count count) {
  std::uint64_t sum = 0;
  for (const FamilyTally& family : families) sum += count(family);
  return sum;
}

void keep_worst(FamilyTally& tally, const SuiteCase& of, std::size_t ray, const Claim& claim,
                const ClaimJudgement& is) {
  std::optional<Finding>& worst = tally.worst[place(is.verdict)];
  if (worst && !is_worse(is, of.the_case.scene.size(), *worst)) return;
  worst = Finding{with_ray_alone(of, ray), ray, claim, is};
}

void keep_sample(FamilyTally& tally, const SuiteCase& of, std::size_t ray, const Claim& claim,
                 const ClaimJudgement& is) {
  if (is.verdict == Verdict::skipped || tally.sample.size() == sample_size(*of.family)) return;
  ++tally.sampled_rays;
  if (is_failure(is.verdict)) tally.sample.push_back({with_ray_alone(of, ray), ray, claim, is});
}

std::size_t failures_in(std::span<const ClaimJudgement> judgements) {
  return static_cast<std::size_t>(
      std::ranges::count_if(judgements, [](const ClaimJudgement& is) { return is_failure(is.verdict); }));
}

bool has_distance(Verdict verdict) {
  return verdict == Verdict::exact || verdict == Verdict::right || verdict == Verdict::off;
}

/// The rank of a verdict: gross is worse than other failures, these are worse than right, and right is worse than
/// exact.
int rank(Verdict verdict) {
  return is_gross(verdict) ? 3 : is_failure(verdict) ? 2 : verdict == Verdict::right ? 1 : 0;
}

Spread spread_of(const SuiteCase& of, std::span<const ClaimJudgement> judgements) {
  Spread spread{.parameter = of.parameter};
  for (const ClaimJudgement& is : judgements) {
    if (std::isfinite(is.backward)) spread.backward = std::max(spread.backward, is.backward);
    if (rank(is.verdict) > rank(spread.worst)) spread.worst = is.verdict;
  }
  return spread;
}

}  // namespace

std::size_t ulp_bin(double ulps) {
  if (!(ulps > 0)) return 0;
  if (!(ulps <= 0x1p63)) return ulp_bins - 1;
  return ulps <= 1 ? 1 : 1 + static_cast<std::size_t>(std::ceil(std::log2(ulps)));
}

std::size_t sample_size(const Family& family) {
  constexpr std::size_t of_ordinary = 32, of_others = 4, of_meshes = 1;
  if (&family == &ordinary_family()) return of_ordinary;
  return &family != &own_family && is_of_meshes(family) ? of_meshes : of_others;
}

bool is_worse(const ClaimJudgement& is, std::size_t elements, const Finding& than) {
  if (is.backward != than.judgement.backward) return is.backward > than.judgement.backward;
  return elements < than.of.the_case.scene.size();
}

SuiteCase with_ray_alone(const SuiteCase& of, std::size_t ray) {
  SuiteCase cut = of;
  cut.the_case.rays = {of.the_case.rays[ray]};
  cut.truths = {of.truths[ray]};
  if (has_numbers(of.question)) cut.ranges = {of.ranges[ray]};
  return cut;
}

bool is_failure(Verdict verdict) { return verdict == Verdict::off || is_gross(verdict); }

std::uint64_t FamilyTally::rays() const { return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}); }
std::uint64_t FamilyTally::gross() const { return sum_where(*this, is_gross); }
std::uint64_t FamilyTally::failures() const { return sum_where(*this, is_failure); }

FamilyTally& Tally::tally_of(const Family& family) {
  const auto known = std::ranges::find(families_, &family, &FamilyTally::family);
  if (known != families_.end()) return *known;
  families_.push_back({.family = &family});
  return families_.back();
}

std::vector<ClaimJudgement> Tally::add(const SuiteCase& of, std::span<const Claim> claims, const Profile& profile) {
  FamilyTally& tally = tally_of(*of.family);
  const std::vector<ClaimJudgement> judgements = CaseJudge(of, profile).judge(claims);
  for (std::size_t ray = 0; ray < claims.size(); ++ray) {
    const ClaimJudgement& is = judgements[ray];
    ++tally.counts[place(is.verdict)];
    if (is.verdict == Verdict::skipped) ++tally.clauses[is.clause];
    if (claims[ray].outcome == Claim::Outcome::hit && has_distance(is.verdict)) ++tally.ulps[ulp_bin(is.ulps)];
    if (is_failure(is.verdict)) keep_worst(tally, of, ray, claims[ray], is);
    keep_sample(tally, of, ray, claims[ray], is);
  }
  tally.spreads.push_back(spread_of(of, judgements));
  const std::size_t failures = failures_in(judgements);
  if (failures > 0 && (!tally.most_failures || failures > failures_in(tally.most_failures->judgements)))
    tally.most_failures = {of, {claims.begin(), claims.end()}, judgements};
  return judgements;
}

std::uint64_t Tally::rays() const {
  return sum_of(families_, [](const FamilyTally& family) { return family.rays(); });
}
std::uint64_t Tally::of(Verdict verdict) const {
  return sum_of(families_, [&](const FamilyTally& family) { return family.of(verdict); });
}
std::uint64_t Tally::gross() const {
  return sum_of(families_, [](const FamilyTally& family) { return family.gross(); });
}
std::uint64_t Tally::failures() const {
  return sum_of(families_, [](const FamilyTally& family) { return family.failures(); });
}

}  // namespace durero::conform
