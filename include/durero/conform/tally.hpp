#pragma once
/// The verdicts on many claims, counted by family, with the worst of each and what pictures need.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "durero/conform/claims_file.hpp"
#include "durero/conform/judge.hpp"

namespace durero::conform {

/// A judged ray, and its case without the other rays: enough to show it and to ask it again.
struct Finding {
  SuiteCase of;         ///< with this ray alone
  std::size_t ray = 0;  ///< its number in the whole case
  Claim claim;          ///< what the system answered to it
  Judgement judgement;  ///< of the claim
};

/// A case and the verdicts on its rays.
struct JudgedCase {
  SuiteCase of;                       ///< with all its rays
  Claims claims;                      ///< in the order of the rays
  std::vector<Judgement> judgements;  ///< in the order of the rays
};

/// How far off the claims on one case were, for a plot against the family's parameter.
struct Spread {
  int parameter = 0;               ///< the family's, as it was drawn for the case
  double backward = 0;             ///< the greatest backward error of a judged hit, in ε
  Verdict worst = Verdict::exact;  ///< of the case
};

/// log₂ of the ulps that hits were off by: 0 (to the bit), then up to 1, 2, 4, … ulps, and more than 2⁶³.
inline constexpr std::size_t ulp_bins = 66;
/// The bin, less than ulp_bins, that a hit off by so many ulps is counted in.
std::size_t ulp_bin(double ulps);

/// The verdicts on the rays of one family.
struct FamilyTally {
  const Family* family = nullptr;                             ///< one of families()
  std::array<std::uint64_t, verdict_count> counts{};          ///< rays, by Verdict
  std::map<std::string, std::uint64_t> clauses{};             ///< what was skipped, by the clause of the profile
  std::array<std::uint64_t, ulp_bins> ulps{};                 ///< of the hits that are exact, right or off
  std::vector<Spread> spreads{};                              ///< a case each
  std::array<std::optional<Finding>, verdict_count> worst{};  ///< by Verdict: the worst ray of each that is a failure
  std::optional<JudgedCase> most_failures{};                  ///< the case with most rays that fail

  /// How many rays have the verdict.
  std::uint64_t of(Verdict verdict) const { return counts[static_cast<std::size_t>(verdict)]; }
  std::uint64_t rays() const;      ///< how many were judged or skipped
  std::uint64_t gross() const;     ///< how many have a gross verdict (is_gross)
  std::uint64_t failures() const;  ///< off, gross or no answer at all
};

/// The case as if it had that ray alone. Precondition: the case was answered.
SuiteCase with_ray_alone(const SuiteCase& of, std::size_t ray);

/// A right system's verdicts are exact, right and skipped alone.
bool is_failure(Verdict verdict);

/// Judges claims, and counts the verdicts family by family.
class Tally {
 public:
  Tally() = default;
  /// What was counted already.
  explicit Tally(std::vector<FamilyTally> families) : families_(std::move(families)) {}

  /// Judges the claims on the rays of a case, and gives the judgements. Precondition: the case was answered, and has as
  /// many rays as claims.
  std::vector<Judgement> add(const SuiteCase& of, std::span<const Claim> claims, const Profile& profile);

  const std::vector<FamilyTally>& families() const { return families_; }  ///< in the order in which they were added
  /// @{ As of a FamilyTally, summed over the families.
  std::uint64_t rays() const;
  std::uint64_t of(Verdict verdict) const;
  std::uint64_t gross() const;
  std::uint64_t failures() const;
  /// @}
  /// Whether some ray was judged, and none failed: what was skipped whole shows nothing.
  bool is_conformant() const { return failures() == 0 && of(Verdict::skipped) < rays(); }

 private:
  FamilyTally& tally_of(const Family& family);
  std::vector<FamilyTally> families_;
};

}  // namespace durero::conform
