#pragma once
/// A report tells the findings on a system to people and programs, with the same content as a table for a terminal,
/// JSON, JUnit XML, SARIF and a page of HTML that stands alone. The families that fail stand first. The same report
/// gives the same bytes.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "durero/conform/judge/explaining_data.hpp"
#include "durero/conform/judge/trait.hpp"
#include "durero/conform/report/tally.hpp"

namespace durero::conform {

/// The key of a worst finding: each family has one of each failing verdict.
struct FindingKey {
  std::string_view family;  ///< the name of one of families(), which lasts as long as the program
  Verdict verdict;          ///< a verdict that is a failure

  /// The key of a finding, which its reduction to a smaller case keeps.
  explicit FindingKey(const Finding& finding) : family(finding.of.family->name), verdict(finding.judgement.verdict) {}
  auto operator<=>(const FindingKey&) const = default;
};

/// A finding reduced to its smallest case, and data that would explain it.
struct LeastFinding {
  Finding finding;                       ///< the reduced finding: its case need not be of any suite
  std::optional<ExplainingData> data{};  ///< nothing for a failure that no data explain, such as a crash
};

/// The share of ordinary rays (ordinary_family) that a cause makes wrong.
struct CauseShare {
  std::uint64_t failing = 0, rays = 0;  ///< so many of so many judged rays
  double least = 0, greatest = 1;       ///< the interval of Clopper and Pearson, of 95 %, for rays drawn as these
};

/// A cause of failures: those of all families and verdicts that the same change makes vanish. Where no change does, the
/// failures on one type of elements stand together.
struct Cause {
  Trait trait = Trait::none;             ///< the trait that the change takes away
  std::string title{};                   ///< the title, a sentence without its end
  std::vector<FindingKey> findings{};    ///< its worst findings, the smallest first
  std::set<Verdict> verdicts{};          ///< the verdicts on its rays
  std::set<std::string> families{};      ///< the names of the families of its rays
  std::uint64_t examined = 0;            ///< the number of its failing rays among those that were examined
  std::optional<CauseShare> ordinary{};  ///< nothing where no ordinary ray was judged
};

/// The causes of the failures in a report.
struct Causes {
  bool were_asked = false;     ///< false: they are guessed from the questions alone, as nobody was there to be asked
  std::vector<Cause> all{};    ///< those with the most ordinary rays first, then those with the most examined ones
  std::uint64_t examined = 0;  ///< the number of failing rays that were examined
  std::uint64_t left_out = 0;  ///< of the chosen ones, the number that were not, for the time was over
};

/// The findings on one system with one suite.
struct Report {
  std::string title;                           ///< the title of the system
  std::string version{};                       ///< as the system says it; empty where it was not asked by this program
  std::string asked{};                         ///< the system's name in a call that asks it again; empty without a name
  Profile profile{};                           ///< the profile that it was judged by
  SuiteOptions options{};                      ///< the options of the suite
  Tally tally{};                               ///< the tally of the verdicts on all its rays
  std::map<FindingKey, LeastFinding> least{};  ///< worst findings, reduced (least_findings.hpp)
  std::size_t not_minimised = 0;               ///< the number of worst findings that the reduction left out
  Causes causes{};                             ///< the causes of its failures (causes.hpp)
};

/// The families, those with gross failures first, then those that are off; otherwise in their order.
std::vector<const FamilyTally*> failures_first(const Tally& tally);

/// The options that make the case of a finding again, and its ray: `--case tiny/0007 --ray 12 --solids`.
std::string replay_options(const SuiteOptions& options, const Finding& finding);

/// @{ The claim in a line without its end: the hit, "a miss", or the reason for neither.
std::string claim_words(const Claim& claim, const scene::Scene& scene);
std::string claim_words(const Finding& finding);
/// @}
/// @{ The exact answer to what is asked about the ray, in a line without its end, with what the claim says besides its
/// place. Precondition: the case was answered.
std::string truth_words(const SuiteCase& of, std::size_t ray, const Claim& claim);
std::string truth_words(const Finding& finding);
/// @}

/// The report as a table with a row for each family and a column for each verdict, then the worst ray of each failing
/// verdict with the call that replays it.
std::string report_text(const Report& report);
/// The report as JSON, {"format":"durero-report","version":1,…}.
std::string report_json(const Report& report);
/// The report as JUnit XML: a suite for the system, a test for each family.
std::string report_junit(const Report& report);
/// The report as SARIF 2.1.0: a rule for each verdict, a result for the worst ray of each family and verdict.
std::string report_sarif(const Report& report);
/// The report as a page of HTML that stands alone: the table, the failing families with pictures and their worst rays,
/// the profile with its sources, and the skipped rays.
std::string report_html(const Report& report);

/// Makes the folder of reports where there is none. Throws io::FileError where nothing can be written into it.
void require_room_for_reports(const std::string& folder);

/// Writes report.json, report.xml (JUnit), report.sarif and report.html into the folder, which is made where there is
/// none. Throws io::FileError.
void write_reports(const std::string& folder, const Report& report);

}  // namespace durero::conform
