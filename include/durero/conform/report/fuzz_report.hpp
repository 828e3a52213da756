#pragma once
/// A report on fuzzing tells the causes of what was found, each by its worst failure made small, and the call that
/// finds them again. It is a text, JSON and a page of HTML.

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

/// The findings of a search in one system.
struct FuzzReport {
  std::string title{};      ///< the title of the system
  std::string version{};    ///< its name and version as it says them; empty where it never answered
  std::string call{};       ///< the call that finds the same again
  std::uint64_t seed = 0;   ///< of the search
  Profile profile{};        ///< the profile that it was judged by
  Fuzzing fuzzing{};        ///< the failures
  FuzzedCauses causes{};    ///< their causes
  bool is_stopped = false;  ///< true where an interrupt ended the search: the failures stand as they were found
};

/// The report as a text: the counts, and each cause with its question, exact answer and explaining data.
std::string fuzz_text(const FuzzReport& report);
/// The report as JSON, {"format":"durero-search","version":1,…}.
std::string fuzz_json(const FuzzReport& report);
/// The report as a page of HTML that stands alone, with a picture of each cause.
std::string fuzz_html(const FuzzReport& report);

/// Writes search.json and search.html into the folder, which is made where there is none. Throws io::FileError.
void write_fuzz_report(const std::string& folder, const FuzzReport& report);

}  // namespace durero::conform
