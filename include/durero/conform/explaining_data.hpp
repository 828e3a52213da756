#pragma once
/// Data that would explain a wrong answer: how far those given must be off for it to be right, and the nearest such
/// data found. Both are judged by the exact judge.

#include <optional>
#include <string>

#include "durero/conform/tally.hpp"

namespace durero::conform {

/// Lengths are measured in ε·M: ε the unit of rounding of the system's format, M the largest magnitude among the
/// coordinates and lengths of the elements, the origin and the first point (expected, or claimed).
struct ExplainingData {
  /// Data with the claim as their answer: a miss exactly, also where all hits are beyond the limits of the profile; a
  /// hit, which is rounded, within the declared error.
  struct Nearest {
    SuiteCase of;    ///< those data: one element, or the origin, is moved, or one length is another
    double off = 0;  ///< by how much, in ε·M
  };

  double epsilon = 0, M = 0;  ///< ε, which is 2⁻²⁴ or 2⁻⁵³, and M, as above
  /// No data with every coordinate and length off by 2^excluded ε·M or less (unit vectors and proportions by 16ε) have
  /// the claim as their answer: proved by the judge with that allowance. Nothing where that is proved of the declared
  /// backward error alone, for which M is each element's own.
  std::optional<int> excluded{};
  int most = 0;                      ///< data off by more than 2^most ε·M were not looked for
  std::optional<Nearest> nearest{};  ///< the nearest data found, which need not be the nearest there are
};

/// Of a failure that is a hit with a place, or a miss; nothing of another, such as a crash: no data explain that.
std::optional<ExplainingData> explaining_data(const Finding& finding, const Profile& profile);

/// The same in sentences, and the question of the nearest data.
std::string explaining_text(const ExplainingData& data, const Profile& profile);

}  // namespace durero::conform
