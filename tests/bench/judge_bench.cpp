// The figure of the judge: how many claims a second it judges on one core, of the generic family: those of right
// tracers of plain arithmetic, most of which need no exact step; and claims that are off, all of which need it.
#include <benchmark/benchmark.h>

#include <stdexcept>
#include <vector>

#include "conform/faults/tracer.hpp"
#include "conform/perturbed.hpp"
#include "durero/conform/judge.hpp"

using namespace durero;

namespace {

constexpr std::size_t rays_a_case = conform::rays_of_a_case;

const std::vector<conform::SuiteCase>& generic_cases() {
  static const std::vector<conform::SuiteCase> cases = [] {
    std::vector<conform::SuiteCase> drawn;
    for (std::uint64_t number = 0; number < 64; ++number) {
      drawn.push_back(conform::suite_case({.rays = 64 * rays_a_case}, *conform::find_family("generic"), number));
      conform::answer(drawn.back());
    }
    return drawn;
  }();
  return cases;
}

/// change(claim) of every claim of a right tracer, judged over and over. Without a change each must be right.
template <class N, class Change>
void judge_all(benchmark::State& state, conform::Format format, bool are_right, Change change) {
  const conform::Profile profile = test::wide_profile(format);
  std::vector<std::vector<conform::Claim>> claims;
  for (const conform::SuiteCase& of : generic_cases()) {
    const test::Tracer<N> tracer(of.the_case.scene);
    claims.emplace_back();
    for (const scene::Query& query : of.the_case.rays) claims.back().push_back(change(tracer.first_hit(query.rayo)));
  }
  std::size_t judged = 0;
  for (auto _ : state) {
    const std::size_t place = judged / rays_a_case % claims.size(), ray = judged % rays_a_case;
    const conform::Judgement judgement = conform::judge(generic_cases()[place], ray, claims[place][ray], profile);
    if (are_right && judgement.verdict > conform::Verdict::right) throw std::logic_error("a right tracer is off");
    benchmark::DoNotOptimize(judgement);
    ++judged;
  }
  state.counters["rays/s"] = benchmark::Counter(static_cast<double>(judged), benchmark::Counter::kIsRate);
}

conform::Claim same(conform::Claim claim) { return claim; }
conform::Claim off(conform::Claim claim) {
  if (claim.t) *claim.t *= 1.001;
  return claim;
}

void right_binary64(benchmark::State& state) { judge_all<double>(state, conform::Format::binary64, true, same); }
void right_binary32(benchmark::State& state) { judge_all<float>(state, conform::Format::binary32, true, same); }
void off_binary64(benchmark::State& state) { judge_all<double>(state, conform::Format::binary64, false, off); }
BENCHMARK(right_binary64);
BENCHMARK(right_binary32);
BENCHMARK(off_binary64);

}  // namespace

BENCHMARK_MAIN();
