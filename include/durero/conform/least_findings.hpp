#pragma once
/// The worst findings of a report, each made as small as it stays one.

#include <chrono>

#include "durero/conform/report.hpp"
#include "durero/conform/runner.hpp"

namespace durero::conform {

/// How much may be spent on it.
struct LeastLimits {
  std::size_t findings = 64;               ///< so many are made small: of each family the first, then the others
  std::chrono::duration<double> time{60};  ///< of all; one that is not done by then is left out
};

/// Fills in Report::least and Report::not_minimised. The same answers give the same, where the time suffices: a finding
/// is made as small as it gets, or is left out.
void minimise_findings(Report& report, const Ask& ask, const LeastLimits& limits);

/// Makes a finding small and looks for what would explain it.
LeastFinding least_finding(const Finding& finding, const Profile& profile, const Ask& ask);

/// A finding in full: the question in decimal and in hexadecimal, the exact answer to 40 digits and as
/// x + y√Δ, what was expected and got, and data that would explain it.
std::string least_text(const LeastFinding& least, const Profile& profile);

/// The question with its numbers as C writes them in hexadecimal.
std::string in_hexadecimal(const std::string& question);

}  // namespace durero::conform
