// The analytic tracer against the set-of-points oracle on a million random rays: Verdict says in both directions
// whether the samples bear out the closed forms.
#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <iostream>

#include "durero/oracle/sampled.hpp"
#include "durero/trace/analytic.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"

using namespace durero;
using oracle::sampled::SampledVerdict;

TEST_CASE("a million random rays: every disagreement with the samples is explained") {
  constexpr std::uint64_t scenes = 50, first_seed = 20'260;
  constexpr std::uint64_t rays_a_scene = test::fewer_when_sanitized(20'000);
  std::array<std::atomic<std::uint64_t>, 6> counts{};
  std::atomic<std::uint64_t> hits = 0, bad_seed = 0;
  tbb::parallel_for(std::uint64_t{0}, scenes, [&](std::uint64_t i) {
    const std::uint64_t seed = first_seed + i;
    test::Random random(seed);
    const scene::Scene scene = test::random_scene(random, 4);
    const oracle::sampled::Oracle oracle(scene);
    for (std::uint64_t n = 0; n < rays_a_scene; ++n) {
      const model::Rayo ray = test::random_ray(random);
      const scene::Hit hit = trace::first_hit(scene, ray);
      hits += hit.resultado == model::Resultado::hit;
      const SampledVerdict verdict = oracle.judge(ray, hit);
      ++counts[static_cast<std::size_t>(verdict)];
      if (!agrees(verdict)) bad_seed = seed;
    }
  });
  for (std::size_t i = 0; i < counts.size(); ++i)
    std::cout << name(static_cast<SampledVerdict>(i)) << ' ' << counts[i] << (i + 1 < counts.size() ? ", " : "\n");
  INFO("replay: test::Random random(" << bad_seed << ")");
  CHECK(counts[static_cast<std::size_t>(SampledVerdict::incomplete)] == 0);
  CHECK(counts[static_cast<std::size_t>(SampledVerdict::unsound)] == 0);
  CHECK(hits > scenes * rays_a_scene / 4);  // rays that test something
  CHECK(counts[static_cast<std::size_t>(SampledVerdict::agrees)] >
        scenes * rays_a_scene * 9 / 10);  // explanations are rare
}
