#pragma once
/// A report on fuzzing tells the causes of what was found, each by its worst failure made small, and the call that
/// finds them again.

#include <set>
#include <string>
#include <vector>

#include "durero/conform/judge/fuzz.hpp"
#include "durero/conform/report/least_findings.hpp"

namespace durero::conform {

/// Failures that fuzzing found and that the same change makes right.
struct FuzzedCause {
  Trait trait = Trait::none;      ///< the trait that the change takes away
  std::string title{};            ///< the title, a sentence without its end
  std::set<Verdict> verdicts{};   ///< the verdicts on its failures
  std::uint64_t alike = 0;        ///< the number of failures of its kinds
  std::uint64_t step = 0;         ///< the number of the question that is shown
  LeastFinding least{Finding{}};  ///< the worst of those that were made small, or else one as it was found
};

/// The causes of what fuzzing found.
struct FuzzedCauses {
  std::vector<FuzzedCause> all{};  ///< those of the most failures first
  std::size_t left_out = 0;        ///< the number of kinds that were not examined: their number or the time was over
};

/// Asks the failures again with changes, and makes the worst of each cause small, within the limits. The same answers
/// give the same causes, where the time suffices.
FuzzedCauses fuzzed_causes(const Fuzzing& fuzzing, const Profile& profile, const Ask& ask, const LeastLimits& limits);

/// The causes as the questions alone tell them, and as they were found: nobody is asked.
FuzzedCauses guessed_causes(const Fuzzing& fuzzing, const Profile& profile);

/// The report as a text: the counts, and each cause with its question, exact answer and explaining data. `call` finds
/// the same again.
std::string fuzz_text(const Fuzzing& fuzzing, const FuzzedCauses& causes, const Profile& profile,
                      const std::string& call);

}  // namespace durero::conform
