#include "durero/conform/judge/agreement.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>

namespace durero::conform {

model::Rayo RaysTowards::next() {
  for (;;) {
    const oracle::BallNode& ball = balls_[random_.below(balls_.size())];
    const glm::dvec3 to = ball.center + random_.in_cube(1) * ball.radius;
    const glm::dvec3 away = random_.in_cube(1);
    const glm::dvec3 from = to + away * (ball.radius * random_.uniform(1, 8));
    if (from != to) return {model::Punto(from), model::Vector(to - from)};
  }
}

std::uint64_t Agreement::rays() const { return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}); }

void Agreement::add(const scene::Query& query, const scene::Hit& claimed, oracle::sampled::SampledVerdict verdict) {
  if (!agrees(verdict) && !first) first = {rays(), query, claimed, verdict};
  ++counts[static_cast<std::size_t>(verdict)];
}

Agreement agreement(const oracle::sampled::Oracle& oracle, const FirstHits& first_hits, std::uint64_t rays,
                    std::uint64_t seed, const std::function<void(std::uint64_t)>& judged) {
  constexpr std::uint64_t block = std::uint64_t{1} << 16U;  // so that memory does not grow with the number of rays
  Agreement agreement;
  const std::vector<oracle::BallNode> balls = oracle.bounds();
  if (balls.empty()) return agreement;
  RaysTowards stream(balls, seed);
  // A ray counts as judged when all its pairs with surfaces are; `judged` receives one ray for as many pairs as there
  // are surfaces.
  std::atomic<std::uint64_t> pairs = 0;
  const auto in_rays = [&](std::uint64_t more) {
    const std::uint64_t before = pairs.fetch_add(more);
    judged((before + more) / balls.size() - before / balls.size());
  };
  for (std::uint64_t done = 0; done < rays; done += block) {
    std::vector<scene::Query> queries;
    while (queries.size() < std::min(block, rays - done)) {
      const scene::Query query{stream.next(), {}};
      queries.push_back(query);
    }
    const std::vector<scene::Hit> hits = first_hits(queries);
    const auto verdicts = oracle.judge(queries, hits, in_rays);
    for (std::size_t i = 0; i < queries.size(); ++i) agreement.add(queries[i], hits[i], verdicts[i]);
  }
  return agreement;
}

}  // namespace durero::conform
