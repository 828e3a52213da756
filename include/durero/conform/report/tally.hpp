#pragma once
/// A tally counts the verdicts on many claims by family, and keeps the worst of each and the data for pictures.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "durero/conform/ask/claims_file.hpp"
#include "durero/conform/judge/judge.hpp"

namespace durero::conform {

/// A judged ray, and its case without the other rays: enough to show the failure and to ask for it again.
struct Finding {
  SuiteCase of;              ///< the case with this ray alone
  std::size_t ray = 0;       ///< its number in the whole case
  Claim claim;               ///< the system's answer
  ClaimJudgement judgement;  ///< the judgement on the claim
};

/// Whether a judgement on a ray of a scene of so many elements is worse than a finding: farther from the surface, then
/// of a scene that is easier to read.
bool is_worse(const ClaimJudgement& is, std::size_t elements, const Finding& than);

/// A case, and the judgements on its rays.
struct JudgedCase {
  SuiteCase of;                            ///< the case with all its rays
  Claims claims;                           ///< in the order of the rays
  std::vector<ClaimJudgement> judgements;  ///< in the order of the rays
};

/// The error of the claims on one case, for a plot against the family's parameter.
struct Spread {
  int parameter = 0;               ///< the family's parameter, as drawn for the case
  double backward = 0;             ///< the greatest backward error of a judged hit, in ε
  Verdict worst = Verdict::exact;  ///< the worst verdict of the case
};

/// The number of bins of a histogram of log₂ of the ulps that hits were off by: 0 (to the bit), then up to 1, 2, 4, …
/// ulps, and more than 2⁶³.
inline constexpr std::size_t ulp_bins = 66;
/// The bin, less than ulp_bins, that counts a hit off by so many ulps.
std::size_t ulp_bin(double ulps);

/// The number of failing rays of a family that a tally keeps as a sample: most of the ordinary ones, whose share
/// counts, and one of a mesh, which is large.
std::size_t sample_size(const Family& family);

/// The verdicts on the rays of one family.
struct FamilyTally {
  const Family* family = nullptr;                     ///< one of families()
  std::array<std::uint64_t, verdict_count> counts{};  ///< the number of rays, by Verdict
  std::map<std::string, std::uint64_t> clauses{};     ///< the number of skipped rays, by the clause of the profile
  std::array<std::uint64_t, ulp_bins> ulps{};         ///< the hits that are exact, right or off, by ulp_bin
  std::vector<Spread> spreads{};                      ///< one for each case
  std::array<std::optional<Finding>, verdict_count> worst{};  ///< the worst ray of each failing verdict, by Verdict
  std::optional<JudgedCase> most_failures{};                  ///< the case with the most failing rays
  std::vector<Finding> sample{};                              ///< the first failing rays, sample_size() at most
  std::uint64_t sampled_rays = 0;  ///< the number of rays that were judged until the sample was full, or all

  /// The number of rays with the verdict.
  std::uint64_t of(Verdict verdict) const { return counts[static_cast<std::size_t>(verdict)]; }
  std::uint64_t rays() const;      ///< the number of rays that were judged or skipped
  std::uint64_t gross() const;     ///< the number of rays with a gross verdict (is_gross)
  std::uint64_t failures() const;  ///< the number of rays whose verdict is_failure
};

/// The case reduced to one of its rays. Preconditions: the case was answered, and has such a ray.
SuiteCase with_ray_alone(const SuiteCase& of, std::size_t ray);

/// Whether the verdict is a failure: it is not exact, right or skipped.
bool is_failure(Verdict verdict);

/// A tally judges claims and counts the verdicts family by family.
class Tally {
 public:
  Tally() = default;
  /// A tally that starts from counts made before.
  explicit Tally(std::vector<FamilyTally> families) : families_(std::move(families)) {}

  /// Judges the claims on the rays of a case, and returns the judgements in the order of the rays. Precondition: the
  /// case was answered, and has as many rays as claims.
  std::vector<ClaimJudgement> add(const SuiteCase& of, std::span<const Claim> claims, const Profile& profile);

  const std::vector<FamilyTally>& families() const { return families_; }  ///< in the order of their first case
  /// @{ The counts of FamilyTally, summed over the families.
  std::uint64_t rays() const;
  std::uint64_t of(Verdict verdict) const;
  std::uint64_t gross() const;
  std::uint64_t failures() const;
  /// @}
  /// Whether at least one ray was judged and none failed. Skipped rays alone show nothing.
  bool is_conformant() const { return failures() == 0 && of(Verdict::skipped) < rays(); }

 private:
  FamilyTally& tally_of(const Family& family);
  std::vector<FamilyTally> families_;
};

}  // namespace durero::conform
