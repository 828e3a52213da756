#pragma once
/// A set of shards holds the findings of a campaign: those of one shard, as `durero conform shard` writes them, or of
/// many, as `durero conform merge` does. Both are one type, and one file:
///
///   {"format":"durero-shards","version":1,"campaign":"0123456789abcdef","system":"embree","says":"Embree 3.13.5",
///   "families":["generic","tiny"],
///   "verdicts":["exact","right","off",…],
///   "shards":[
///   {"shard":17,"answers":"fedcba9876543210","ulps":[850,90,60],"clauses":["no disco"],
///    "families":[[[900,100],[24]],[[512]]]}
///   ],
///   "failures":[
///   {"family":"tiny","verdict":"missed","case":1088,"ray":12,"elements":3,"backward":2097152,"claim":"miss"}
///   ],"digest":"…"}
///
/// `ulps` counts the hits of a shard that are off by 0, by up to 1, 2, 4, … ulps. A family counts its rays of each
/// verdict, and the skipped rays of each clause. Lists end before their last zeros, and before their last empty lists:
/// a campaign has tens of thousands of shards, and all of them go into one file. `answers` is a digest of all answers
/// of the system. For each family and verdict `failures` has the worst ray, and the rays whose number has the least
/// hash, which are as good as drawn by lot; `claim` is the answer to the ray, as question.hpp writes it. The last
/// member is a digest of all bytes before it.
///
/// The union of such sets is associative, commutative and idempotent, since each part is: the shards are a set, and so
/// are the failing rays of which the worst and the least are kept. Two shards of one number are both kept where they
/// differ: the system is not deterministic, or a machine is broken.

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "durero/conform/campaign/campaign.hpp"
#include "durero/conform/report/tally.hpp"

namespace durero::conform {

/// The numbers of a family in a shard. No list ends with 0.
struct FamilyCounts {
  std::vector<std::uint64_t> verdicts;  ///< the number of rays by Verdict, except skipped, the last
  std::vector<std::uint64_t> clauses;   ///< the number of skipped rays, by ShardCounts::clauses
  auto operator<=>(const FamilyCounts&) const = default;
};

/// The numbers of a shard.
struct ShardCounts {
  std::uint64_t shard = 0;               ///< its number in the campaign, from 0
  std::uint64_t answers = 0;             ///< a digest of the system's answers, ray after ray
  std::vector<std::uint64_t> ulps{};     ///< the number of hits of all families, by ulp_bin
  std::vector<std::string> clauses{};    ///< the clauses of skipped rays, ascending
  std::vector<FamilyCounts> families{};  ///< in the order of the campaign's families, up to the last with a ray
  auto operator<=>(const ShardCounts&) const = default;
};

/// A ray that failed, with the data to ask it again.
struct FailedRay {
  std::uint64_t number = 0;  ///< the number of its case, in its family
  std::size_t ray = 0;       ///< its number in the case
  std::size_t elements = 0;  ///< the number of elements of the scene
  double backward = 0;       ///< the backward error of the judgement; not NaN
  std::string claim{};       ///< as claim_text writes it
  auto operator<=>(const FailedRay&) const = default;
};

/// The number of rays of a family and a verdict that are kept by their hash.
inline constexpr std::size_t failures_kept = 8;

/// The number of clauses of a shard that are counted apart: those that skip most rays. A system may refuse rays in as
/// many words as it likes; all other clauses are counted together.
inline constexpr std::size_t clauses_kept = 16;
/// The clause that stands for all other clauses, and for clauses of more than 200 bytes.
inline constexpr std::string_view other_clauses = "other clauses";

/// The kept rays of a family that failed with one verdict: the worst, and those of least hash.
class FailedRays {
 public:
  /// Whether add() may keep a ray with these numbers, whatever was claimed; false only where it would not.
  bool may_keep(const FailedRay& ray) const;
  /// Keeps the ray where it is worse than the worst, or among the failures_kept of least hash.
  void add(const FailedRay& ray);

  /// The worst ray: the one farthest from the surface, then of the smallest scene, then the first. Precondition: a ray
  /// was added.
  const FailedRay& worst() const { return worst_.value(); }
  /// All kept rays, ascending.
  std::set<FailedRay> all() const;

 private:
  std::optional<FailedRay> worst_;
  std::vector<FailedRay> least_;  // ascending by hash
};

/// A set of shards of one campaign.
struct Shards {
  std::string says{};              ///< the system's name and version; empty where it was asked nothing
  std::set<ShardCounts> counts{};  ///< two entries have one number where the shard had different contents
  std::map<std::pair<const Family*, Verdict>, FailedRays> failures{};  ///< by family and failing verdict
};

/// Adds the shards of another set of the same campaign. Throws std::invalid_argument where the system was another
/// version of itself.
void unite(Shards& shards, Shards other);

/// A tally of the claims on the cases of one shard, in the order of its cases.
class ShardTally {
 public:
  /// A tally without counts. The campaign and the profile must outlive it.
  ShardTally(const Campaign& campaign, std::uint64_t shard, const Profile& profile)
      : campaign_(&campaign), shard_(shard), profile_(&profile) {}

  /// Judges the claims on the rays of the next case. Precondition: the case was answered, and has as many rays as
  /// claims.
  void add(const SuiteCase& of, std::span<const Claim> claims);
  /// The set that has this shard alone.
  Shards shards(const std::string& says) const;

 private:
  const Campaign* campaign_;
  std::uint64_t shard_;
  const Profile* profile_;
  Tally tally_;
  std::uint64_t answers_ = 0;
  std::map<std::pair<const Family*, Verdict>, FailedRays> failures_;
};

/// The text of the file. `identity` is that of the campaign.
std::string shards_text(const Shards& shards, const Campaign& campaign, const std::string& identity);

/// Reads such a file. Throws io::InputError where it is not whole, was altered, or is of another campaign.
Shards read_shards(const io::Source& source, const Campaign& campaign, const std::string& identity);

}  // namespace durero::conform
