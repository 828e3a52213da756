#include "durero/conform/report/causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <functional>
#include <optional>
#include <tuple>

#include "conform/report/report_parts.hpp"

namespace durero::conform {
namespace {

using CauseClock = std::chrono::steady_clock;

/// The failing rays to examine: the ordinary ones first, as their share counts, then the worst of each family and
/// verdict, then the other samples.
std::vector<const Finding*> chosen_failures(const Tally& tally) {
  std::vector<const Finding*> all;
  std::set<std::pair<std::string, std::size_t>> rays;
  const auto add = [&](const Finding& finding) {
    if (rays.emplace(finding.of.name(), finding.ray).second) all.push_back(&finding);
  };
  const auto add_samples = [&](bool of_ordinary) {
    for (const FamilyTally& family : tally.families()) {
      if ((family.family == &ordinary_family()) == of_ordinary) std::ranges::for_each(family.sample, add);
    }
  };
  add_samples(true);
  for (const FamilyTally& family : tally.families()) {
    for (const Finding* finding : findings_of(family)) add(*finding);
  }
  add_samples(false);
  return all;
}

/// The causes of failures while they are counted.
class CauseCount {
 public:
  explicit CauseCount(const Report& report) : report_(&report) {}

  void add(const Finding& finding, Trait trait) {
    Cause& cause = cause_with(trait, cause_title(trait, finding, report_->profile));
    ++cause.examined;
    cause.verdicts.insert(finding.judgement.verdict);
    cause.families.emplace(finding.of.family->name);
    ordinary_[cause.title] += finding.of.family == &ordinary_family() && is_in_sample(finding);
    ++causes_.examined;
    if (is_worst(finding)) cause.findings.emplace_back(finding);
  }

  Causes result(bool were_asked, std::uint64_t left_out) && {
    causes_.were_asked = were_asked;
    causes_.left_out = left_out;
    for (Cause& cause : causes_.all) {
      cause.ordinary = share_of(cause);
      std::ranges::stable_sort(cause.findings, {}, [&](const FindingKey& key) { return length_of(key); });
    }
    std::ranges::stable_sort(causes_.all, std::greater<>(), [&](const Cause& cause) {
      return std::pair{ordinary_[cause.title], cause.examined};
    });
    return std::move(causes_);
  }

 private:
  Cause& cause_with(Trait trait, const std::string& title) {
    const auto known = std::ranges::find(causes_.all, title, &Cause::title);
    if (known != causes_.all.end()) return *known;
    return causes_.all.emplace_back(Cause{.trait = trait, .title = title});
  }

  const FamilyTally* tally_of(std::string_view family) const {
    const auto& all = report_->tally.families();
    const auto found = std::ranges::find(all, family, [](const FamilyTally& of) { return of.family->name; });
    return found == all.end() ? nullptr : &*found;
  }

  bool is_in_sample(const Finding& finding) const {
    return std::ranges::any_of(tally_of(finding.of.family->name)->sample, [&](const Finding& of) {
      return of.of.number == finding.of.number && of.ray == finding.ray;
    });
  }

  bool is_worst(const Finding& finding) const {
    const FamilyTally& family = *tally_of(finding.of.family->name);
    const std::optional<Finding>& worst = family.worst[static_cast<std::size_t>(finding.judgement.verdict)];
    return worst && worst->of.number == finding.of.number && worst->ray == finding.ray;
  }

  /// The share of ordinary rays; nothing where none was judged, or where the time was over before all were examined.
  std::optional<CauseShare> share_of(const Cause& cause) const {
    const FamilyTally* const ordinary = tally_of(ordinary_family().name);
    if (ordinary == nullptr || ordinary->sampled_rays == 0 || causes_.examined < ordinary->sample.size())
      return std::nullopt;
    return cause_share(ordinary_.at(cause.title), ordinary->sampled_rays);
  }

  /// The order of findings: reduced ones first, those of fewer elements, then gross ones, then those of shorter
  /// questions.
  std::tuple<bool, std::size_t, bool, std::size_t> length_of(const FindingKey& key) const {
    const auto least = report_->least.find(key);
    const bool is_least = least != report_->least.end();
    const Finding& finding =
        is_least ? least->second.finding : *tally_of(key.family)->worst[static_cast<std::size_t>(key.verdict)];
    return {!is_least, finding.of.the_case.scene.size(), !is_gross(key.verdict),
            question_of(finding, report_->profile).size()};
  }

  const Report* report_;
  Causes causes_;
  std::map<std::string, std::uint64_t> ordinary_;  // failing ordinary rays, by the title of their cause
};

}  // namespace

CauseShare cause_share(std::uint64_t failing, std::uint64_t rays) {
  // In binary64 throughout: a long double differs between machines.
  using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  using Binomial = boost::math::binomial_distribution<double, Policy>;
  constexpr double one_side = 0.025;
  const double n = static_cast<double>(rays), k = static_cast<double>(failing);
  return {.failing = failing,
          .rays = rays,
          .least = Binomial::find_lower_bound_on_p(n, k, one_side),
          .greatest = Binomial::find_upper_bound_on_p(n, k, one_side)};
}

void find_causes(Report& report, const Ask& ask, const CauseLimits& limits) {
  const auto end = CauseClock::now() + limits.time;
  const std::vector<const Finding*> chosen = chosen_failures(report.tally);
  CauseCount count(report);
  std::uint64_t left_out = chosen.size();
  for (const Finding* finding : chosen) {
    if (CauseClock::now() >= end) break;
    count.add(*finding, cause_of(*finding, report.profile, ask));
    --left_out;
  }
  report.causes = std::move(count).result(true, left_out);
}

void guess_causes(Report& report) {
  CauseCount count(report);
  for (const Finding* finding : chosen_failures(report.tally))
    count.add(*finding, likely_cause(*finding, report.profile));
  report.causes = std::move(count).result(false, 0);
}

}  // namespace durero::conform
