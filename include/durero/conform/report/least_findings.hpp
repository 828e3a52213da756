#pragma once
/// A least finding is one of the worst findings of a report, reduced to the smallest case that still fails.

#include <chrono>

#include "durero/conform/ask/runner.hpp"
#include "durero/conform/report/report.hpp"

namespace durero::conform {

/// The limits of the reduction.
struct LeastLimits {
  std::size_t findings = 64;               ///< the number of findings to reduce: first one of each family, then others
  std::chrono::duration<double> time{60};  ///< the time for all; a finding that is not done by then is left out
};

/// Fills in Report::least and Report::not_minimised. The same answers give the same report, where the time suffices: a
/// finding is reduced fully, or is left out.
void minimise_findings(Report& report, const Ask& ask, const LeastLimits& limits);

/// The reduced finding, with the data that would explain it.
LeastFinding least_finding(const Finding& finding, const Profile& profile, const Ask& ask);

/// The question of the finding with all its elements, as a system reads it.
std::string least_question(const LeastFinding& least, const Profile& profile);

/// The finding in full: the question in decimal and in hexadecimal, the exact answer to 40 digits and as x + y√Δ, the
/// expected and the given answer, and data that would explain it.
std::string least_text(const LeastFinding& least, const Profile& profile);

/// The question with its numbers as C writes them in hexadecimal.
std::string in_hexadecimal(const std::string& question);

}  // namespace durero::conform
