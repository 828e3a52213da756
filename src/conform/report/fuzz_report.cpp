#include "durero/conform/report/fuzz_report.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <tuple>

#include "conform/report/report_parts.hpp"

namespace durero::conform {
namespace {

using FuzzClock = std::chrono::steady_clock;

/// The signal that the time for examining is over.
struct FuzzTimeOver {};

/// The kinds of failures in the order in which they are examined: gross ones first, then those of most failures.
std::vector<const FuzzedFailure*> most_first(const Fuzzing& fuzzing) {
  std::vector<const FuzzedFailure*> all;
  for (const FuzzedFailure& kind : fuzzing.failing) all.push_back(&kind);
  std::ranges::stable_sort(all, std::greater<>(), [](const FuzzedFailure* kind) {
    return std::pair{is_gross(kind->finding.judgement.verdict), kind->alike};
  });
  return all;
}

/// The severity of a reduced finding: the data that are excluded, then being gross, then few elements.
std::tuple<int, bool, std::size_t> severity_of(const LeastFinding& least) {
  const int excluded = least.data ? least.data->excluded.value_or(0) : 0;
  return {excluded, is_gross(least.finding.judgement.verdict), ~least.finding.of.the_case.scene.size()};
}

class FuzzedCauseCount {
 public:
  explicit FuzzedCauseCount(const Profile& profile) : profile_(&profile) {}

  /// Adds a kind with its trait; `small` makes a finding small, and is called for the first kinds of each cause.
  template <class Small>
  void add(const FuzzedFailure& kind, Trait trait, Small small) {
    constexpr int most_reduced = 3;
    const std::string title = cause_title(trait, kind.finding, *profile_);
    auto known = std::ranges::find(causes_, title, &FuzzedCause::title);
    const bool is_new = known == causes_.end();
    if (is_new || reduced_[title] < most_reduced) {
      ++reduced_[title];
      LeastFinding least = small(kind.finding);
      if (is_new) known = causes_.insert(causes_.end(), {.trait = trait, .title = title, .least = least});
      if (is_new || severity_of(least) > severity_of(known->least)) {
        known->least = std::move(least);
        known->step = kind.step;
      }
    }
    known->verdicts.insert(kind.finding.judgement.verdict);
    known->alike += kind.alike;
  }

  FuzzedCauses result(std::size_t left_out) && {
    std::ranges::stable_sort(causes_, std::greater<>(), &FuzzedCause::alike);
    return {std::move(causes_), left_out};
  }

 private:
  const Profile* profile_;
  std::vector<FuzzedCause> causes_;
  std::map<std::string, int> reduced_;
};

}  // namespace

FuzzedCauses fuzzed_causes(const Fuzzing& fuzzing, const Profile& profile, const Ask& ask, const LeastLimits& limits) {
  const auto end = FuzzClock::now() + limits.time;
  const Ask within_time = [&](const SuiteCase& of) {
    if (FuzzClock::now() >= end) throw FuzzTimeOver();
    return ask(of);
  };
  FuzzedCauseCount count(profile);
  const std::vector<const FuzzedFailure*> kinds = most_first(fuzzing);
  std::size_t examined = 0;
  try {
    for (; examined < std::min(limits.findings, kinds.size()); ++examined) {
      const FuzzedFailure& kind = *kinds[examined];
      const Trait trait = cause_of(kind.finding, profile, within_time);
      count.add(kind, trait, [&](const Finding& finding) { return least_finding(finding, profile, within_time); });
    }
  } catch (const FuzzTimeOver&) {
  }
  return std::move(count).result(kinds.size() - examined);
}

FuzzedCauses guessed_causes(const Fuzzing& fuzzing, const Profile& profile) {
  FuzzedCauseCount count(profile);
  for (const FuzzedFailure* kind : most_first(fuzzing))
    count.add(*kind, likely_cause(kind->finding, profile),
              [](const Finding& finding) { return LeastFinding{finding}; });
  return std::move(count).result(0);
}

}  // namespace durero::conform
