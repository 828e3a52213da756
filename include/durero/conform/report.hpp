#pragma once
/// What was found of a system, for people and for programs: the same content as a table for a terminal, JSON, JUnit
/// XML, SARIF and a page of HTML that stands alone. The families that fail stand first. The same report gives the same
/// bytes.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "durero/conform/explaining_data.hpp"
#include "durero/conform/tally.hpp"

namespace durero::conform {

/// Which of the worst findings: a family has one of each verdict.
struct FindingKey {
  std::string_view family;  ///< of one of families(): it lasts as long as the program
  Verdict verdict;          ///< one that is a failure

  /// Of the family and the verdict of the finding, which making it small leaves as they are.
  explicit FindingKey(const Finding& finding) : family(finding.of.family->name), verdict(finding.judgement.verdict) {}
  auto operator<=>(const FindingKey&) const = default;
};

/// A finding made as small as it stays one, and what data would explain it.
struct LeastFinding {
  Finding finding;                       ///< the small one: its case need not be of any suite
  std::optional<ExplainingData> data{};  ///< none of a failure that no data explain, such as a crash
};

/// What was found of one system on one suite.
struct Report {
  std::string title;                           ///< of the system
  std::string version{};                       ///< as the system says it; empty where it was not asked by this program
  std::string asked{};                         ///< what names the system in a call that asks it again; empty: nothing
  Profile profile{};                           ///< that it was judged by
  SuiteOptions options{};                      ///< of the suite
  Tally tally{};                               ///< of the verdicts on all its rays
  std::map<FindingKey, LeastFinding> least{};  ///< worst findings, made as small as they stay ones (least_findings.hpp)
  std::size_t not_minimised = 0;               ///< how many of them were left out, where they were to be made small
};

/// The families, those with gross failures first, then those that are off; otherwise in their order.
std::vector<const FamilyTally*> failures_first(const Tally& tally);

/// The options that make the case of a finding again, and its ray: `--case tiny/0007 --ray 12 --solids`.
std::string replay_options(const SuiteOptions& options, const Finding& finding);

/// What was claimed, in a line without its end: the hit, "a miss", or why there is neither.
std::string claim_words(const Finding& finding);
/// The exact answer, in a line without its end. Precondition: the case was answered.
std::string truth_words(const Finding& finding);

/// A row a family, a column a verdict, then the worst of each failing verdict with the call that replays it.
std::string report_text(const Report& report);
/// {"format":"durero-report","version":1,…}
std::string report_json(const Report& report);
/// A suite a system, a test a family.
std::string report_junit(const Report& report);
/// SARIF 2.1.0: a rule a verdict, a result for the worst ray of each family and verdict.
std::string report_sarif(const Report& report);
/// A page of HTML that stands alone: the table, the families that fail with pictures and their worst rays, the profile
/// with its sources, and what was skipped.
std::string report_html(const Report& report);

/// Makes the folder where there is none. Throws io::FileError where nothing can be written into it.
void require_room_for_reports(const std::string& folder);

/// Writes report.json, report.xml (JUnit), report.sarif and report.html into the folder, which is made where there is
/// none. Throws io::FileError.
void write_reports(const std::string& folder, const Report& report);

}  // namespace durero::conform
