// durero stats SCENE [RAYS] [--engine E]… [--hierarchy H] [--bounds] [--sphere-tracing] [--format F] [--no-times]: what
// each structure costs, and what it saves.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "description.hpp"
#include "durero/conform/families/rays_towards.hpp"
#include "durero/conform/format_versions.hpp"
#include "durero/engine/engine.hpp"
#include "durero/engine/prepared.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/rays/rays_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/text/shown.hpp"
#include "engines.hpp"
#include "progress.hpp"
#include "stats_bounds.hpp"
#include "stats_sphere_tracing.hpp"

namespace durero::cli {
namespace {

using engine::Figures;

struct StatsOptions {
  std::string scene, rays, format = "text", hierarchy;
  std::vector<std::string> engines;
  bool bounds = false, sphere_tracing = false, no_times = false, quiet = false;
};

/// The number of rays that are drawn where no file is named.
constexpr std::size_t own_rays = 1000;
constexpr std::uint64_t own_seed = 1;

/// The engine without a structure, with which the others are compared.
constexpr std::string_view without = "analytic";

struct Measured {
  const engine::EngineRow* engine;
  bool by_hand;  ///< its hierarchy is that of the scene's groups
  Figures figures;
  std::optional<double> break_even;  ///< the number of rays from which on it pays; none where it never does
};

std::vector<std::string> measurable() {
  std::vector<std::string> names;
  for (const engine::EngineRow& row : engine::engines())
    if (row.measure != nullptr) names.emplace_back(row.name);
  return names;
}

std::vector<scene::Query> rays_of(const StatsOptions& options, const scene::Scene& scene) {
  if (options.rays.empty()) return conform::rays_towards(scene, own_rays, own_seed);
  return io::read_rays(io::read_lines(options.rays), scene);
}

/// The number of rays that win back the time to build the structure: each saves the difference of the times per ray.
std::optional<double> break_even(const Figures& own, const Figures& linear) {
  const double saved = own.without_seconds.value_or(linear.answering_seconds) - own.answering_seconds;
  const double built = own.building_seconds - linear.building_seconds;
  if (own.work.rays == 0 || !(saved > 0)) return std::nullopt;
  return std::max(0.0, std::ceil(built / saved * static_cast<double>(own.work.rays)));
}

/// Whether the hierarchy of the groups is measured: without a choice, it stands beside the automatic one where a scene
/// has groups.
bool is_wanted_by_hand(const StatsOptions& options, const scene::Groups& groups) {
  return options.hierarchy.empty() ? !groups.empty() : options.hierarchy == engine::by_hand;
}

std::vector<Measured> measured(const StatsOptions& options, const scene::GroupedScene& input,
                               std::span<const scene::Query> rays) {
  const scene::Scene& scene = input.scene;
  const auto& asked = options.engines;
  const bool is_all = asked.empty();
  const Figures linear = engine::find(without)->measure(scene, rays);
  std::vector<Measured> all;
  Progress progress(options.quiet, "stats", "engines", is_all ? measurable().size() : asked.size());
  for (const engine::EngineRow& row : engine::engines()) {
    if (row.measure == nullptr || (!is_all && std::ranges::find(asked, row.name) == asked.end())) continue;
    const bool is_linear = row.name == without;
    const auto add = [&](bool by_hand, const Figures& figures) {
      all.push_back({&row, by_hand, figures, is_linear ? std::nullopt : break_even(figures, linear)});
    };
    const bool has_hand = row.measure_by_hand != nullptr;
    if (!has_hand || options.hierarchy != engine::by_hand) add(false, is_linear ? linear : row.measure(scene, rays));
    if (has_hand && is_wanted_by_hand(options, input.groups)) add(true, row.measure_by_hand(scene, rays, input.groups));
    progress.add();
  }
  return all;
}

/// `12.34`, by ray; `-` where there is no ray.
std::string per_ray(std::uint64_t count, std::uint64_t rays) {
  return rays == 0 ? "-" : fmt::format("{:.2f}", static_cast<double>(count) / static_cast<double>(rays));
}

std::string times(const Measured& of) {
  const Figures& figures = of.figures;
  const auto rays = static_cast<double>(figures.work.rays);
  return fmt::format("{:>12.6f}{:>12}{:>12}", figures.building_seconds,
                     rays > 0 ? fmt::format("{:.3f}", figures.answering_seconds / rays * 1e6) : "-",
                     of.break_even ? fmt::format("{:.0f}", *of.break_even) : "-");
}

std::string name_of(const Measured& of) { return fmt::format("{}{}", of.engine->name, of.by_hand ? " by hand" : ""); }

/// The branching of the hierarchies, a line each; empty where there is none.
std::string branchings(const std::vector<Measured>& all) {
  constexpr auto head = "{:<19}{:>12}{:>8}{:>8}{:>8}\n";
  std::string text;
  for (const Measured& of : all) {
    if (!of.figures.branching) continue;
    const auto& [cost, arity, most] = *of.figures.branching;
    if (text.empty()) text = "\n" + fmt::format(head, "hierarchy", "cost", "depth", "arity", "most");
    text += fmt::format(head, name_of(of), fmt::format("{:.4f}", cost), of.figures.size.depth,
                        fmt::format("{:.2f}", arity), most);
  }
  return text;
}

/// The figures that are asked for besides.
struct MoreFigures {
  std::optional<engine::BoundsFigures> bounds;
  std::vector<engine::SphereTracingFigures> sphere_tracing;
};

void print_text(const StatsOptions& options, const scene::Scene& scene, std::size_t rays,
                const std::vector<Measured>& all, const MoreFigures& more) {
  constexpr auto head = "{:<19}{:<14}{:>8}{:>8}{:>11}{:>10}{:>10}{:>11}{:>11}";
  std::string text = fmt::format("{}: {} elementos, {} rays\n", text::escaped(options.scene), scene.size(), rays);
  text += fmt::format(head, "engine", "asked", "nodes", "cells", "bytes", "n/ray", "m/ray", "nodes/ray", "cells/ray");
  text += options.no_times ? "\n" : fmt::format("{:>12}{:>12}{:>12}\n", "build s", "µs/ray", "break-even");
  for (const Measured& of : all) {
    const auto& size = of.figures.size;
    const auto& work = of.figures.work;
    text += fmt::format(head, name_of(of), of.figures.asked, size.nodes, size.cells, size.bytes,
                        per_ray(work.volumes, work.rays), per_ray(work.candidates, work.rays),
                        per_ray(work.nodes, work.rays), per_ray(work.cells, work.rays));
    text += options.no_times ? "\n" : times(of) + "\n";
  }
  text += branchings(all) + (more.bounds ? bounds_text(*more.bounds, scene, options.no_times) : "");
  io::print(text + sphere_tracing_text(more.sphere_tracing));
}

struct NamedCount {
  const char* key;
  std::uint64_t value;
};

void write_counts(io::json::Writer& out, const char* key, std::initializer_list<NamedCount> counts) {
  out.key(key).begin_object();
  for (const auto& [name, value] : counts) out.member(name, value);
  out.end_object();
}

void write(io::json::Writer& out, const Measured& of, bool no_times) {
  const auto& size = of.figures.size;
  const auto& work = of.figures.work;
  out.new_line().begin_object().member("engine", of.engine->name).member("section", of.engine->section);
  out.member("asked", of.figures.asked);
  write_counts(out.new_line(), "size",
               {{"elements", size.elements},
                {"apart", size.apart},
                {"nodes", size.nodes},
                {"cells", size.cells},
                {"references", size.references},
                {"depth", size.depth},
                {"bytes", size.bytes}});
  write_counts(out.new_line(), "work",
               {{"rays", work.rays},
                {"volumes", work.volumes},
                {"nodes", work.nodes},
                {"cells", work.cells},
                {"by_miss", work.by_miss},
                {"by_distance", work.by_distance},
                {"candidates", work.candidates},
                {"repeated", work.repeated},
                {"untested", work.untested}});
  if (of.figures.branching) {
    const auto& [cost, arity, most] = *of.figures.branching;
    out.new_line().key("hierarchy").begin_object().member("made", of.by_hand ? "by hand" : "automatically");
    out.member("cost", cost).member("arity", arity).member("most", std::uint64_t{most}).end_object();
  }
  if (!no_times) {
    out.new_line().key("seconds").begin_object().member("building", of.figures.building_seconds);
    out.member("answering", of.figures.answering_seconds);
    out.end_object();
    if (of.break_even) out.member("break_even", *of.break_even);
  }
  out.end_object();
}

void print_json(const StatsOptions& options, const scene::Scene& scene, std::size_t rays,
                const std::vector<Measured>& all, const MoreFigures& more) {
  std::string text;
  io::json::Writer out(text);
  write_version(out.begin_object(), conform::stats_format);
  out.member("file", text::escaped(options.scene)).member("elementos", std::uint64_t{scene.size()});
  out.new_line().key("rays").begin_object().member("count", std::uint64_t{rays});
  if (options.rays.empty()) {
    out.member("seed", own_seed);
  } else {
    out.member("file", text::escaped(options.rays));
  }
  out.end_object().new_line().key("engines").begin_array();
  for (const Measured& of : all) write(out, of, options.no_times);
  out.end_array();
  if (more.bounds) write_bounds(out, *more.bounds, scene, options.no_times);
  write_sphere_tracing(out, more.sphere_tracing);
  out.end_object();
  io::print(text + "\n");
}

int run(const StatsOptions& options) {
  const scene::GroupedScene input = io::read_grouped_scene(io::read_source(options.scene));
  const scene::Scene& scene = input.scene;
  const std::vector<scene::Query> rays = rays_of(options, scene);
  const std::vector<Measured> all = measured(options, input, rays);
  MoreFigures more;
  if (options.bounds) more.bounds = engine::bounds_figures(scene, rays, !options.no_times);
  if (options.sphere_tracing) more.sphere_tracing = sphere_tracing_figures(scene, rays);
  (options.format == "json" ? print_json : print_text)(options, scene, rays.size(), all, more);
  return 0;
}

}  // namespace

void add_stats(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("stats", "What each acceleration structure costs, and what it saves");
  const auto options = std::make_shared<StatsOptions>();
  command->add_option("SCENE", options->scene, "Scene file (JSON); - is the standard input")->required();
  command->add_option("RAYS", options->rays, "Ray file, as trace takes it; without it, 1000 rays of its own");
  command->add_option("--engine", options->engines, "Only this engine; may be given again")
      ->check(one_of("engine", measurable()))
      ->allow_extra_args(false);
  command->add_option("--hierarchy", options->hierarchy, "Of bvh: this alone; without it, both where there are groups")
      ->check(one_of("hierarchy", {std::string(engine::automatic), std::string(engine::by_hand)}));
  command->add_flag("--bounds", options->bounds, "Of bounding volumes besides: fit, choice and cost of each element's");
  command->add_flag("--sphere-tracing", options->sphere_tracing,
                    "Of the engine sdf besides: which rays it loses, at its epsilon and at greater ones");
  command->add_option("--format", options->format, "How the answer is printed")
      ->check(one_of("format", {"text", "json"}))
      ->capture_default_str();
  command->add_flag("--no-times", options->no_times, "Only what is counted: the same bytes at every call");
  add_quiet(*command, options->quiet);
  command->footer(fmt::format(
      "Each structure is built, and finds the first hits of the rays one by one. The rays of its own go towards "
      "elements\n"
      "chosen at random, and are always the same: {} of seed {}. n counts tests of volumes and planes, m elements\n"
      "whose surface is tested; break-even is the number of rays from which on the time to build it has been won\n"
      "back, against {}, which tries the ball of every element. The cost of a hierarchy is that of Goldsmith and\n"
      "Salmon, the tests of a line that meets its root; arity is the mean number of children. Of bounding volumes B "
      "and\n"
      "I are what a test of a volume and of an element takes, T is n·B + m·I for a ray; void area is what the volume\n"
      "covers and the element's hull does not, in the mean over directions of the rays, mean fit over all.\n\n"
      "Of many elements the choice of volumes takes longest, some tenths of a millisecond each. Where many share a\n"
      "corner, every structure tries most of them on a ray that comes there, so that time grows with their number\n"
      "times the rays.\n\n{}{}",
      own_rays, own_seed, without, exit_status("the figures are printed", "the call or a file is bad"),
      examples({"stats demo/still-life.json", "stats demo/still-life.json demo/rays.txt --format json --no-times"})));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
