#pragma once
/// The agreement of an engine's first hits with the sampled oracle, on random rays.

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

/// A stream of random rays that come near the elements of a scene: each goes towards the surroundings of an element
/// chosen at random, from a place up to eight times its size away. The rays are drawn in order from one stream, and a
/// seed and a number name a ray.
class RaysTowards {
 public:
  /// A stream towards these balls. Precondition: there is at least one.
  RaysTowards(std::vector<oracle::BallNode> balls, std::uint64_t seed) : balls_(std::move(balls)), random_(seed) {}
  /// The next ray of the stream. Its v leads from its origin to the place aimed at, which is at t = 1 but for a
  /// rounding.
  model::Rayo next();

 private:
  std::vector<oracle::BallNode> balls_;
  Random random_;
};

/// The verdicts of the samples on the hits of many rays.
struct Agreement {
  /// A claimed hit that is wrong, as the samples show.
  struct Disagreement {
    std::uint64_t ray;                        ///< its number in the stream, from 0
    scene::Query query;                       ///< the ray; it starts on no elements
    scene::Hit claimed;                       ///< the engine's answer
    oracle::sampled::SampledVerdict verdict;  ///< incomplete or unsound
  };

  std::array<std::uint64_t, oracle::sampled::verdict_count> counts{};  ///< rays, by verdict
  std::optional<Disagreement> first;                                   ///< the first ray whose hit is wrong

  /// The number of rays with the verdict.
  std::uint64_t of(oracle::sampled::SampledVerdict verdict) const { return counts[static_cast<std::size_t>(verdict)]; }
  /// The number of rays that were judged: the sum of the counts.
  std::uint64_t rays() const;
  /// Counts the next ray of the stream, and keeps it where it is the first whose claim is wrong.
  void add(const scene::Query& query, const scene::Hit& claimed, oracle::sampled::SampledVerdict verdict);
};

/// A function that answers rays with the first hit of each.
using FirstHits = std::function<std::vector<scene::Hit>(std::span<const scene::Query>)>;

/// Asks for the first hits of the first `rays` rays of a seed, many at once, and judges them. A scene without elements
/// has no rays. `judged` receives the number of rays judged since its last call, on any thread; the sum is `rays`.
Agreement agreement(
    const oracle::sampled::Oracle& oracle, const FirstHits& first_hits, std::uint64_t rays, std::uint64_t seed,
    const std::function<void(std::uint64_t)>& judged = [](std::uint64_t) {});

/// The call that an agreement answers.
struct AgreementCall {
  const io::Source& file;     ///< the file of the scene
  const scene::Scene& scene;  ///< the scene, which names the elements of the hits
  std::string_view engine;    ///< the name of the engine that answered
  std::uint64_t seed;         ///< the seed of the rays
};

/// The agreement as JSON, {"format":"durero-agreement","version":1,…}: the number of rays of each verdict, and the
/// first ray whose hit is wrong, with the places of the elements that it names.
std::string agreement_json(const Agreement& agreement, const AgreementCall& call);

}  // namespace durero::conform
