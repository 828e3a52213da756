// durero agree SCENE [--rays N] [--seed S] [--engine E]: an engine against the sampled oracle on random rays.
#include <fmt/format.h>

#include <limits>
#include <memory>
#include <span>
#include <stdexcept>

#include "commands.hpp"
#include "durero/conform/agreement.hpp"
#include "durero/io/rays_file.hpp"
#include "durero/io/scene_file.hpp"
#include "durero/oracle/sampled.hpp"
#include "engines.hpp"
#include "numbers.hpp"

namespace durero::cli {
namespace {

using conform::Agreement;
using oracle::sampled::Verdict;

struct Options {
  std::string scene;
  std::string engine{engine::default_engine};
  std::uint64_t rays = 100'000, seed = 1;
  double fineness = oracle::sampled::default_fineness;
  std::size_t threads = 0;
};

int report(const Agreement& agreement, const Options& options, const scene::Scene& scene) {
  const auto of = [&](Verdict verdict) { return agreement.of(verdict); };
  fmt::print("{} rays: {} agree in both directions\n", agreement.rays(), of(Verdict::agrees));
  fmt::print("explained: {} grazing, {} at a rim, {} at the origin\n", of(Verdict::grazing), of(Verdict::rim),
             of(Verdict::origin));
  fmt::print("unexplained: {}\n", of(Verdict::incomplete) + of(Verdict::unsound));
  if (!agreement.first) return 0;
  fmt::print("the first is ray {} of --seed {}: {}\n", agreement.first->ray, options.seed,
             name(agreement.first->verdict));
  fmt::print("{}", io::rays_text({&agreement.first->query, 1}, scene));
  return 1;
}

int run(const Options& options) {
  const ThreadLimit limit(options.threads);
  const scene::Scene scene = io::read_scene(io::read_source(options.scene));
  try {
    const oracle::sampled::Oracle oracle(scene, options.fineness);
    const auto engine = engine::find(options.engine)->prepare(scene);
    const auto first_hits = [&](std::span<const scene::Query> queries) { return engine::first_hits(*engine, queries); };
    return report(conform::agreement(oracle, first_hits, options.rays, options.seed), options, scene);
  } catch (const std::domain_error& error) {  // the range of the oracle
    throw std::domain_error(fmt::format("{}: {}", options.scene, error.what()));
  } catch (const std::length_error& error) {
    throw std::length_error(fmt::format("{}: {}", options.scene, error.what()));
  }
}

}  // namespace

void add_agree(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("agree", "Hold an engine against the sampled oracle on random rays");
  const auto options = std::make_shared<Options>();
  command->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
  command->add_option("--rays", options->rays, "How many rays")
      ->check(whole_number(1, 100'000'000))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Which rays")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  add_engine(*command, options->engine);
  command
      ->add_option("--fineness", options->fineness, "Covering radius of the samples, as a share of an element's radius")
      ->check(number(0x1p-10, 1.0))
      ->capture_default_str();
  command->footer(fmt::format(
      "The oracle knows each surface as points. It takes elements with lengths from {} to {}, and centres\n"
      "with coordinates up to {}; other scenes are refused.\n"
      "Status 0: no hit is wrong; 1: some hit is, and the first such ray is printed; 2: a bad call or scene.",
      oracle::sampled::least_length, oracle::sampled::greatest_length, oracle::sampled::greatest_length));
  add_threads(*command, options->threads);
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
