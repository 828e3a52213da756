#pragma once
/// The causes of a report group its failures by what makes them vanish (trait.hpp): a system's many failing families
/// have few causes.

#include <chrono>

#include "durero/conform/ask/runner.hpp"
#include "durero/conform/report/report.hpp"

namespace durero::conform {

/// The limits of the search for causes.
struct CauseLimits {
  std::chrono::duration<double> time{30};  ///< the time for all; failures that are not examined by then are left out
};

/// Fills in Report::causes by asking the system the failures again with one change each. It examines the worst findings
/// and the samples of the tally. The same answers give the same causes, where the time suffices.
void find_causes(Report& report, const Ask& ask, const CauseLimits& limits);

/// Fills in Report::causes by what the failing questions have in common, where no system is there to be asked.
void guess_causes(Report& report);

/// The share of ordinary rays, so many of so many that were judged, with its interval.
CauseShare cause_share(std::uint64_t failing, std::uint64_t rays);

}  // namespace durero::conform
