#pragma once
/// Explaining data are changed data for which a wrong answer would be right: this finds the nearest, and how far the
/// data given must be off at least. The exact judge decides both.

#include <optional>
#include <string>

#include "durero/conform/report/tally.hpp"

namespace durero::conform {

/// The explanation of a wrong answer. Lengths are measured in ε·M: ε is the unit of rounding of the system's format, M
/// the largest magnitude among the coordinates and lengths of the elements, the origin and the first point (expected,
/// or claimed).
struct ExplainingData {
  /// Data that have the claim as their answer. A miss is their exact answer, also where all hits are beyond the limits
  /// of the profile; a hit, which is rounded, is right within the declared error.
  struct Nearest {
    SuiteCase of;    ///< a case with these data: one element or the origin is moved, or one length changed
    double off = 0;  ///< the change, in ε·M
  };

  double epsilon = 0, M = 0;  ///< ε, which is 2⁻²⁴ or 2⁻⁵³, and M, as above
  /// No data with every coordinate and length off by 2^excluded ε·M or less (unit vectors and proportions by 16ε) have
  /// the claim as their answer: proved by the judge with that allowance. Nothing where that is proved of the declared
  /// backward error alone, for which M is each element's own.
  std::optional<int> excluded{};
  int most = 0;                      ///< the search tried data off by 2^most ε·M at most
  std::optional<Nearest> nearest{};  ///< the nearest data found, which need not be the nearest there are
};

/// The explaining data of a failure that is a hit with a place, or a miss. Nothing for another failure, such as a
/// crash, which no data explain.
std::optional<ExplainingData> explaining_data(const Finding& finding, const Profile& profile);

/// The explanation in sentences, and the question with the nearest data.
std::string explaining_text(const ExplainingData& data, const Profile& profile);

}  // namespace durero::conform
