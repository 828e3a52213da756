// durero agree SCENE [--rays N] [--seed S] [--engine E | --with TEXT] [--format F]: an engine, or a Z text, against the
// sampled oracle on random rays.
#include <fmt/format.h>
#include <unistd.h>

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>

#include "by_text.hpp"
#include "colour.hpp"
#include "commands.hpp"
#include "description.hpp"
#include "durero/composed/engine.hpp"
#include "durero/conform/judge/agreement.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/rays/rays_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/oracle/sampled.hpp"
#include "engines.hpp"
#include "file_error.hpp"
#include "numbers.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

using conform::Agreement;
using oracle::sampled::SampledVerdict;

struct AgreeOptions {
  std::string scene, format = "text";
  std::string engine{engine::default_engine}, with;
  std::uint64_t rays = 100'000, seed = 1;
  double fineness = oracle::sampled::default_fineness;
  std::size_t threads = 0;
  bool quiet = false;
};

void print_text(const Agreement& agreement, const AgreeOptions& options, const scene::Scene& scene) {
  const auto of = [&](SampledVerdict verdict) { return agreement.of(verdict); };
  const std::string unexplained =
      fmt::format("unexplained: {}", of(SampledVerdict::incomplete) + of(SampledVerdict::unsound));
  std::string text =
      fmt::format("{} rays: {} agree in both directions\n", agreement.rays(), of(SampledVerdict::agrees));
  text += fmt::format("explained: {} grazing, {} at a rim, {} at the origin\n", of(SampledVerdict::grazing),
                      of(SampledVerdict::rim), of(SampledVerdict::origin));
  text += (agreement.first ? in_red(unexplained, STDOUT_FILENO) : unexplained) + '\n';
  if (agreement.first) {
    text += fmt::format("the first is ray {} of --seed {}: {}\n", agreement.first->ray, options.seed,
                        name(agreement.first->verdict));
    text += io::rays_text({&agreement.first->query, 1}, scene);
  }
  io::print(text);
}

int report(const Agreement& agreement, const AgreeOptions& options, const io::Source& file, const scene::Scene& scene) {
  if (options.format == "json") {
    const std::string& answers = options.with.empty() ? options.engine : options.with;
    io::print(conform::agreement_json(agreement, {file, scene, answers, options.seed}));
  } else {
    print_text(agreement, options, scene);
  }
  return agreement.first ? 1 : 0;
}

/// Reads the scene, with the engine that answers rays on it if that is a text's.
written::Written read(const AgreeOptions& options, const io::Source& file) {
  if (options.with.empty()) return {io::read_scene(file, io::Bodies::read), {}, nullptr};
  return read_shapes_by_text(file, options.with);
}

int run(const AgreeOptions& options) {
  const ThreadLimit limit(options.threads);
  const io::Source file = io::read_source(options.scene);
  written::Written asked = read(options, file);
  const scene::Scene& scene = asked.scene;
  const auto judge = [&] {
    std::optional<Progress> progress(std::in_place, options.quiet, "agree", "rays", options.rays);
    const oracle::sampled::Oracle oracle(scene, options.fineness);
    const auto engine =
        asked.engine ? std::move(asked.engine) : composed::prepared(*engine::find(options.engine), scene);
    const auto first_hits = [&](std::span<const scene::Query> queries) { return engine::first_hits(*engine, queries); };
    const Agreement agreement = conform::agreement(oracle, first_hits, options.rays, options.seed,
                                                   [&](std::uint64_t more) { progress->add(more); });
    progress.reset();
    return report(agreement, options, file, scene);
  };
  // The oracle has a range, and a limit of its memory.
  return naming_file<std::domain_error>(options.scene,
                                        [&] { return naming_file<std::length_error>(options.scene, judge); });
}

}  // namespace

void add_agree(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("agree", "Hold an engine, or a Z text, against the sampled oracle on random rays");
  const auto options = std::make_shared<AgreeOptions>();
  command->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
  command->add_option("--rays", options->rays, "How many rays")
      ->check(whole_number(1, 100'000'000))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Which rays")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  add_engine(*command, options->engine);
  add_with(*command, options->with);
  command
      ->add_option("--fineness", options->fineness, "Covering radius of the samples, as a share of an element's radius")
      ->check(number(0x1p-10, 1.0))
      ->capture_default_str();
  command->add_option("--format", options->format, "How the answer is printed")
      ->check(one_of("format", {"text", "json"}))
      ->capture_default_str();
  command->footer(fmt::format(
      "The oracle knows each surface as points. It takes elements with lengths from {} to {}, and centres\n"
      "with coordinates up to {}; other scenes are refused. An instance has the points of its original where the\n"
      "map puts them, a solid those of its parts that are on its surface. Each ray is held against each surface, so\n"
      "that time grows with their product, and no more than {} MiB of points are held at once. With --with it is the\n"
      "text that is held against the points: the types are the program's, their surfaces what the text says of\n"
      "them.\n\n{}{}",
      oracle::sampled::least_length, oracle::sampled::greatest_length, oracle::sampled::greatest_length,
      oracle::sampled::Oracle::usual_bytes >> 20U,
      exit_status("no hit is wrong", "some hit is, and the first such ray is printed", "the call or the scene is bad"),
      examples({"agree demo/still-life.json --rays 10000",
                "agree demo/still-life.json --rays 1000 --with spec/puntos.tex"})));
  add_threads(*command, options->threads);
  add_quiet(*command, options->quiet);
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
