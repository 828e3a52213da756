// durero agree SCENE [--rays N] [--seed S] [--engine E]: an engine against the set-of-points oracle on random rays.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <array>
#include <atomic>
#include <memory>
#include <random>
#include <vector>

#include "commands.hpp"
#include "durero/io/scene_file.hpp"
#include "durero/oracle/sampled.hpp"
#include "engines.hpp"

namespace durero::cli {
namespace {

using oracle::sampled::Verdict;

struct Options {
  std::string scene;
  std::string engine{engine::default_engine};
  std::uint64_t rays = 100'000, seed = 1;
  double fineness = oracle::sampled::default_fineness;
  std::size_t threads = 0;
};

/// Random rays that have something to say of the scene: towards the surroundings of an element chosen at random, from
/// a place up to eight times its size away. Drawn in order from one stream, so a seed and a number name a ray.
std::vector<model::Rayo> random_rays(const oracle::sampled::Oracle& oracle, std::uint64_t count, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (double(engine() >> 11U) * 0x1p-53);
  };
  const auto in_cube = [&] { return glm::dvec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)); };
  std::vector<model::Rayo> rays;
  rays.reserve(count);
  const auto balls = oracle.bounds();
  while (rays.size() < count) {
    const oracle::Ball& ball = balls[engine() % balls.size()];
    const glm::dvec3 to = ball.center + in_cube() * ball.radius;
    const glm::dvec3 from = to + in_cube() * (ball.radius * uniform(1, 8));
    if (from != to) rays.emplace_back(model::Punto(from), model::Vector(to - from));
  }
  return rays;
}

int report(const std::vector<Verdict>& verdicts, const Options& options) {
  std::array<std::size_t, 6> counts{};
  std::size_t first_wrong = verdicts.size();
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    ++counts[static_cast<std::size_t>(verdicts[i])];
    if (!agrees(verdicts[i])) first_wrong = std::min(first_wrong, i);
  }
  const auto of = [&](Verdict v) { return counts[static_cast<std::size_t>(v)]; };
  fmt::print("{} rays: {} agree in both directions\n", verdicts.size(), of(Verdict::agrees));
  fmt::print("explained: {} grazing, {} at a rim, {} at the origin\n", of(Verdict::grazing), of(Verdict::rim),
             of(Verdict::origin));
  fmt::print("unexplained: {}\n", of(Verdict::incomplete) + of(Verdict::unsound));
  if (first_wrong == verdicts.size()) return 0;
  fmt::print("the first is ray {} of --seed {}: {}\n", first_wrong, options.seed, name(verdicts[first_wrong]));
  return 1;
}

int run(const Options& options) {
  const ThreadLimit limit(options.threads);
  const scene::Scene scene = io::read_scene(io::read_source(options.scene));
  if (scene.size() == 0) return report({}, options);
  const oracle::sampled::Oracle oracle(scene, options.fineness);
  const std::vector<model::Rayo> rays = random_rays(oracle, options.rays, options.seed);
  std::vector<scene::Query> queries;
  queries.reserve(rays.size());
  for (const model::Rayo& ray : rays) queries.push_back({ray});
  const std::vector<scene::Hit> hits = engine::first_hits(*engine::find(options.engine)->prepare(scene), queries);
  std::vector<Verdict> verdicts(rays.size());
  tbb::parallel_for(std::size_t{0}, rays.size(), [&](std::size_t i) { verdicts[i] = oracle.judge(rays[i], hits[i]); });
  return report(verdicts, options);
}

}  // namespace

void add_agree(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("agree", "Hold an engine against the set-of-points oracle on random rays");
  const auto options = std::make_shared<Options>();
  command->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
  command->add_option("--rays", options->rays, "How many rays")
      ->check(CLI::Range(1, 100'000'000))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Which rays")->capture_default_str();
  add_engine(*command, options->engine);
  command
      ->add_option("--fineness", options->fineness, "Covering radius of the samples, as a share of an element's radius")
      ->check(CLI::Range(0x1p-10, 1.0))
      ->capture_default_str();
  add_threads(*command, options->threads);
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
