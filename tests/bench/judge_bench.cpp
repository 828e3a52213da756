// The figures of making and judging, on one core, of the generic family: how many rays a second are drawn and answered
// exactly; how many claims a second are judged, those of right tracers of plain arithmetic, most of which need no exact
// step, and claims that are off, all of which need it; and both together, which is what a run costs without the system.
#include <benchmark/benchmark.h>

#include <stdexcept>
#include <vector>

#include "conform/faults/tracer.hpp"
#include "conform/perturbed.hpp"
#include "durero/conform/judge/judge.hpp"

using namespace durero;

namespace {

constexpr std::size_t rays_a_case = conform::rays_of_a_case;

constexpr std::uint64_t case_count = 64;

conform::SuiteCase answered_case(std::uint64_t number, conform::NumberFormat numbers) {
  const conform::SuiteOptions options{.rays = case_count * rays_a_case, .numbers = numbers};
  conform::SuiteCase of = conform::suite_case(options, *conform::find_family("generic"), number);
  conform::answer(of);
  return of;
}

const std::vector<conform::SuiteCase>& generic_cases() {
  static const std::vector<conform::SuiteCase> cases = [] {
    std::vector<conform::SuiteCase> drawn;
    for (std::uint64_t number = 0; number < case_count; ++number)
      drawn.push_back(answered_case(number, conform::NumberFormat::binary32));
    return drawn;
  }();
  return cases;
}

void count_rays(benchmark::State& state, std::size_t rays) {
  state.counters["rays/s"] = benchmark::Counter(static_cast<double>(rays), benchmark::Counter::kIsRate);
}

void make(benchmark::State& state, conform::NumberFormat numbers) {
  std::uint64_t number = 0;
  for (auto _ : state) benchmark::DoNotOptimize(answered_case(number++ % case_count, numbers));
  count_rays(state, number * rays_a_case);
}

template <class N>
std::vector<conform::Claim> claims_of(const conform::SuiteCase& of) {
  const test::Tracer<N> tracer(of.the_case.scene);
  std::vector<conform::Claim> claims;
  for (const scene::Query& query : of.the_case.rays) claims.push_back(tracer.first_hit(query.rayo));
  return claims;
}

/// The tracer's own time is outside.
template <class N>
void make_and_judge(benchmark::State& state, conform::NumberFormat format) {
  const conform::Profile profile = test::wide_profile(format);
  std::vector<std::vector<conform::Claim>> claims;
  for (const conform::SuiteCase& of : generic_cases()) claims.push_back(claims_of<N>(of));
  std::uint64_t number = 0;
  for (auto _ : state) {
    const std::uint64_t place = number++ % case_count;
    const conform::SuiteCase of = answered_case(place, conform::NumberFormat::binary32);
    for (std::size_t ray = 0; ray < rays_a_case; ++ray)
      benchmark::DoNotOptimize(conform::judge(of, ray, claims[place][ray], profile));
  }
  count_rays(state, number * rays_a_case);
}

/// change(claim) of every claim of a right tracer, judged over and over. Without a change each must be right.
template <class N, class Change>
void judge_all(benchmark::State& state, conform::NumberFormat format, bool are_right, Change change) {
  const conform::Profile profile = test::wide_profile(format);
  std::vector<std::vector<conform::Claim>> claims;
  for (const conform::SuiteCase& of : generic_cases()) {
    claims.push_back(claims_of<N>(of));
    for (conform::Claim& claim : claims.back()) claim = change(claim);
  }
  std::size_t judged = 0;
  for (auto _ : state) {
    const std::size_t place = judged / rays_a_case % claims.size(), ray = judged % rays_a_case;
    const conform::ClaimJudgement judgement = conform::judge(generic_cases()[place], ray, claims[place][ray], profile);
    if (are_right && judgement.verdict > conform::Verdict::right) throw std::logic_error("a right tracer is off");
    benchmark::DoNotOptimize(judgement);
    ++judged;
  }
  count_rays(state, judged);
}

conform::Claim same(conform::Claim claim) { return claim; }
conform::Claim off(conform::Claim claim) {
  if (claim.t) *claim.t *= 1.001;
  return claim;
}

/// A closed mesh of so many faces, with rays from inside in any direction, unanswered.
conform::SuiteCase mesh_case(std::size_t faces, std::size_t rays) {
  const conform::Family& family = *conform::find_family("mesh_solid");
  conform::DrawnCase drawn =
      *conform::generate(family, 1, 0, {.numbers = conform::NumberFormat::binary32, .faces = faces});
  conform::Random random(1);
  for (std::size_t i = 0; i < rays; ++i) {
    const glm::dvec3 p(glm::vec3(0.25 * random.in_cube(1))), v(glm::vec3(random.direction()));
    drawn.the_case.rays.emplace_back(scene::Query{{model::Punto(p), model::Vector(v)}, {}});
  }
  return {.family = &family, .the_case = std::move(drawn.the_case)};
}

/// Exact answers to the rays of a mesh, its tree among the work.
void mesh_truths(benchmark::State& state) {
  conform::SuiteCase of = mesh_case(static_cast<std::size_t>(state.range(0)), 100'000);
  for (auto _ : state) conform::answer(of);
  count_rays(state, of.the_case.rays.size() * state.iterations());
}

/// Claims on the rays of a mesh, right ones rounded to binary32, or misses of a system that claims to be watertight.
void mesh_judged(benchmark::State& state, bool are_misses) {
  conform::SuiteCase of = mesh_case(static_cast<std::size_t>(state.range(0)), 100'000);
  conform::answer(of);
  conform::Profile profile = test::wide_profile(conform::NumberFormat::binary32);
  profile.watertight = true;
  std::vector<conform::Claim> claims;
  for (const conform::ExactAnswer& truth : of.truths) {
    const bool is_miss = are_misses || truth.hit.resultado != model::Resultado::hit;
    claims.push_back(is_miss ? conform::Claim{.outcome = conform::Claim::Outcome::miss}
                             : conform::Claim{.outcome = conform::Claim::Outcome::hit,
                                              .element = truth.hit.elementos[0],
                                              .t = static_cast<double>(static_cast<float>(truth.hit.t))});
  }
  if (are_misses) {
    claims.resize(1000), of.truths.resize(1000);
    of.the_case.rays.erase(of.the_case.rays.begin() + 1000, of.the_case.rays.end());
  }
  for (auto _ : state) benchmark::DoNotOptimize(conform::CaseJudge(of, profile).judge(claims));
  count_rays(state, claims.size() * state.iterations());
}
void mesh_right(benchmark::State& state) { mesh_judged(state, false); }
void mesh_missed(benchmark::State& state) { mesh_judged(state, true); }
BENCHMARK(mesh_truths)->Arg(1000)->Arg(100'000);
BENCHMARK(mesh_right)->Arg(1000)->Arg(100'000);
BENCHMARK(mesh_missed)->Arg(5000)->Arg(100'000);

void right_binary64(benchmark::State& state) { judge_all<double>(state, conform::NumberFormat::binary64, true, same); }
void right_binary32(benchmark::State& state) { judge_all<float>(state, conform::NumberFormat::binary32, true, same); }
void off_binary64(benchmark::State& state) { judge_all<double>(state, conform::NumberFormat::binary64, false, off); }
void make_binary64(benchmark::State& state) { make(state, conform::NumberFormat::binary64); }
void make_binary32(benchmark::State& state) { make(state, conform::NumberFormat::binary32); }
void make_and_judge_binary64(benchmark::State& state) {
  make_and_judge<double>(state, conform::NumberFormat::binary64);
}
void make_and_judge_binary32(benchmark::State& state) { make_and_judge<float>(state, conform::NumberFormat::binary32); }
BENCHMARK(make_binary64);
BENCHMARK(make_binary32);
BENCHMARK(make_and_judge_binary64);
BENCHMARK(make_and_judge_binary32);
BENCHMARK(right_binary64);
BENCHMARK(right_binary32);
BENCHMARK(off_binary64);

}  // namespace

BENCHMARK_MAIN();
