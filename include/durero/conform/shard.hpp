#pragma once
/// What was found of the shards of a campaign: of one, as `durero conform shard` writes it, or of many, as `durero
/// conform merge` does. Both are one thing, a set of shards, and one file:
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
/// `ulps` is how many hits of a shard are off by 0, by up to 1, 2, 4, … ulps. A family is how many of its rays have
/// each verdict, and how many were skipped by each clause. Lists end before their last zeros, and before their last
/// empty lists: a campaign has tens of thousands of shards, and all of them go into one file. `answers` is a digest of
/// all that the system answered. Of each family and verdict `failures` has the worst ray, and of the others those whose
/// number has the least hash, which are as good as drawn by lot; `claim` is what was answered to it, as question.hpp
/// writes it. The last member is a digest of all bytes before it.
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

#include "durero/conform/campaign.hpp"
#include "durero/conform/tally.hpp"

namespace durero::conform {

/// The numbers of a family in a shard. No list ends with 0.
struct FamilyCounts {
  std::vector<std::uint64_t> verdicts;  ///< by Verdict, but for skipped, the last
  std::vector<std::uint64_t> clauses;   ///< rays that were skipped, by ShardCounts::clauses
  auto operator<=>(const FamilyCounts&) const = default;
};

/// The numbers of a shard.
struct ShardCounts {
  std::uint64_t shard = 0;               ///< its number in the campaign, from 0
  std::uint64_t answers = 0;             ///< a digest of what the system answered, ray after ray
  std::vector<std::uint64_t> ulps{};     ///< of all families, by ulp_bin
  std::vector<std::string> clauses{};    ///< ascending
  std::vector<FamilyCounts> families{};  ///< in the order of the campaign's, up to the last that was asked something
  auto operator<=>(const ShardCounts&) const = default;
};

/// A ray that failed, with what it takes to ask it again.
struct FailedRay {
  std::uint64_t number = 0;  ///< of its case, among those of its family
  std::size_t ray = 0;       ///< in the case
  std::size_t elements = 0;  ///< of the scene
  double backward = 0;       ///< of the judgement; no NaN
  std::string claim{};       ///< as claim_text writes it
  auto operator<=>(const FailedRay&) const = default;
};

/// How many rays of a family and a verdict are kept by their hash.
inline constexpr std::size_t failures_kept = 8;

/// How many clauses of a shard are counted apart: those that skip most rays. A system may refuse rays in as many words
/// as it likes; the rest is counted together.
inline constexpr std::size_t clauses_kept = 16;
/// The clause that the rest is counted under; so are clauses of more than 200 bytes.
inline constexpr std::string_view other_clauses = "other clauses";

/// Of the rays of a family that failed in one way, the worst and those of least hash.
class FailedRays {
 public:
  /// Whether it would keep a ray with these numbers, whatever was claimed; true also where it may.
  bool may_keep(const FailedRay& ray) const;
  /// Keeps the ray where it is worse than the worst, or among the failures_kept of least hash.
  void add(const FailedRay& ray);

  /// The ray that is farthest from the surface; of those, the one of the smallest scene, then the first.
  const FailedRay& worst() const { return worst_.value(); }
  /// All that are kept, ascending.
  std::set<FailedRay> all() const;

 private:
  std::optional<FailedRay> worst_;
  std::vector<FailedRay> least_;  // ascending by hash
};

/// A set of shards of one campaign.
struct Shards {
  std::string says{};              ///< what the system says of itself; empty where it was asked nothing
  std::set<ShardCounts> counts{};  ///< a number stands twice where its shard was found in two ways
  std::map<std::pair<const Family*, Verdict>, FailedRays> failures{};  ///< by family, and verdict that is a failure
};

/// Adds the shards of another set of the same campaign. Throws std::invalid_argument where the system was another
/// version of itself.
void unite(Shards& shards, Shards other);

/// Counts the claims on the cases of one shard, in the order of its cases.
class ShardTally {
 public:
  /// Nothing is counted yet. The campaign and the profile must outlive it.
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

/// The file. `identity` is that of the campaign.
std::string shards_text(const Shards& shards, const Campaign& campaign, const std::string& identity);

/// Reads one. Throws io::InputError where it is not whole, was altered, or is of another campaign.
Shards read_shards(const io::Source& source, const Campaign& campaign, const std::string& identity);

}  // namespace durero::conform
