#pragma once
/// First hits held against the sampled oracle on random rays.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "durero/conform/random.hpp"
#include "durero/io/source.hpp"
#include "durero/oracle/sampled.hpp"
#include "durero/scene/query.hpp"

namespace durero::conform {

/// Random rays that have something to say of a scene: towards the surroundings of an element chosen at random, from a
/// place up to eight times its size away. They are drawn in order from one stream, so a seed and a number name a ray.
class RaysTowards {
 public:
  /// Towards these balls, at least one.
  RaysTowards(std::vector<oracle::Ball> balls, std::uint64_t seed) : balls_(std::move(balls)), random_(seed) {}
  /// The next ray of the stream. Its v leads from its origin to the place aimed at, which is at t = 1 but for a
  /// rounding.
  model::Rayo next();

 private:
  std::vector<oracle::Ball> balls_;
  Random random_;
};

/// How the hits of many rays stand to the samples.
struct Agreement {
  /// A claimed hit that is wrong, as the samples show.
  struct Disagreement {
    std::uint64_t ray;                 ///< its number in the stream, from 0
    scene::Query query;                ///< the ray; it starts on no elements
    scene::Hit claimed;                ///< what the engine answered
    oracle::sampled::Verdict verdict;  ///< incomplete or unsound
  };

  std::array<std::uint64_t, oracle::sampled::verdict_count> counts{};  ///< rays, by verdict
  std::optional<Disagreement> first;                                   ///< the first ray whose hit is wrong

  /// How many rays have the verdict.
  std::uint64_t of(oracle::sampled::Verdict verdict) const { return counts[static_cast<std::size_t>(verdict)]; }
  /// How many rays were judged: the sum of the counts.
  std::uint64_t rays() const;
  /// Counts the next ray of the stream, and keeps it where it is the first whose claim is wrong.
  void add(const scene::Query& query, const scene::Hit& claimed, oracle::sampled::Verdict verdict);
};

/// What answers the rays: the first hit of each.
using FirstHits = std::function<std::vector<scene::Hit>(std::span<const scene::Query>)>;

/// Asks for the first hits of the first `rays` rays of a seed, many at once, and judges them. A scene without elements
/// has no rays. `judged` is told of how many rays more, by any thread; the sum is `rays`.
Agreement agreement(
    const oracle::sampled::Oracle& oracle, const FirstHits& first_hits, std::uint64_t rays, std::uint64_t seed,
    const std::function<void(std::uint64_t)>& judged = [](std::uint64_t) {});

/// What was asked.
struct AgreementCall {
  const io::Source& file;     ///< of the scene
  const scene::Scene& scene;  ///< in which the elements of the hits are named
  std::string_view engine;    ///< the name of what answered
  std::uint64_t seed;         ///< of the rays
};

/// {"format":"durero-agreement","version":1,…}: how many rays had which verdict, and the first whose hit is wrong, with
/// the places of the elements that it names.
std::string agreement_json(const Agreement& agreement, const AgreementCall& call);

}  // namespace durero::conform
