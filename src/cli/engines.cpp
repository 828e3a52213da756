// durero engines, and the options --engine, --hierarchy and --with.
#include "engines.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <vector>

#include "commands.hpp"
#include "description.hpp"
#include "durero/engine/prepared.hpp"
#include "durero/io/standard_output.hpp"
#include "numbers.hpp"

namespace durero::cli {
namespace {

std::vector<std::string> names(bool with_origins_only = false) {
  std::vector<std::string> names;
  for (const engine::EngineRow& row : engine::engines())
    if (row.honours_origins || !with_origins_only) names.emplace_back(row.name);
  return names;
}

/// A technique of the seed's classification (A §1.1): the idea of each way to be faster, the section that describes it,
/// and its engines and options; where none is named, the engines of that section and of those below.
struct Technique {
  std::string_view head, name, section;
  std::string_view by = {};
};
constexpr std::string_view cheaper = "faster search, by cheaper tests", fewer = "faster search, by fewer tests",
                           fewer_rays = "fewer rays", wider_rays = "rays that are more than lines";
constexpr std::array heads = {cheaper, fewer, fewer_rays, wider_rays};
constexpr std::array techniques = {
    Technique{cheaper, "intersections of fewer operations", "A §1.1", "analytic"},
    Technique{cheaper, "bounding volumes", "A §1.2"},
    Technique{fewer, "hierarchies of bounding volumes", "A §1.3"},
    Technique{fewer, "adaptive subdivision of space", "A §1.4.2"},
    Technique{fewer, "uniform subdivision of space", "A §1.4.3"},
    Technique{fewer, "item buffer", "A §1.5"},
    Technique{fewer, "light buffer", "A §1.6.1"},
    Technique{fewer, "ray classification", "A §1.6", "classification"},
    Technique{fewer_rays, "statistical antialiasing", "A §1.1", "render --sampling statistical"},
    Technique{fewer_rays, "adaptive depth control", "A §1.7", "render --min-weight"},
    Technique{wider_rays, "cones", "A §1.1", "render --rays cones"},
    Technique{wider_rays, "beams", "A §1.1", "render --rays beams"},
    Technique{wider_rays, "pencils", "A §1.1", "render --rays pencils"},
};

/// Every engine, one a line, with what it promises.
std::string promises() {
  std::string text;
  for (const engine::EngineRow& row : engine::engines())
    text += fmt::format("{:18} {}\n{:18} {}; {}\n", row.name, row.what, "",
                        row.exact_bytes ? "the same bytes as exact" : "not the bytes of exact",
                        row.honours_origins ? "honours the elements that a ray starts on"
                                            : "knows nothing of the elements that a ray starts on");
  return text;
}

/// The engines and options with a technique, in words.
std::string had_by(const Technique& technique) {
  if (!technique.by.empty()) return std::string(technique.by);
  std::vector<std::string_view> names;
  for (const engine::EngineRow& row : engine::engines())
    if (row.section.starts_with(technique.section)) names.push_back(row.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Every technique, under its head.
std::string classification() {
  std::string text;
  for (const std::string_view head : heads) {
    std::string below;
    for (const Technique& technique : techniques) {
      if (technique.head == head)
        below += fmt::format("  {} ({}): {}\n", technique.name, technique.section, had_by(technique));
    }
    text += fmt::format("\n{}:\n{}", head, below.empty() ? "  none\n" : below);
  }
  return text;
}

/// The counters of an engine with a structure.
constexpr std::string_view counters =
    "\nof each in this list durero stats counts nodes, cells and bytes held; volumes (n), elements (m), nodes and "
    "cells a "
    "ray;\nand takes the time to build it, and the number of rays from which on it pays\n";

int run() {
  io::print(promises() + classification() + std::string(counters));
  return 0;
}

}  // namespace

void add_engine(CLI::App& command, std::string& name) {
  command.add_option("--engine", name, "What computes the hits, as durero engines lists")
      ->check(one_of("engine", names()))
      ->capture_default_str();
}

void add_max_depth(CLI::App& command, std::optional<std::uint32_t>& max_depth) {
  command
      .add_option("--max-depth", max_depth,
                  "Rays in a row from mirror to mirror; without it, the scene's, or else what its materials need")
      ->check(whole_number(1, scene::greatest_depth));
}

void add_hierarchy(CLI::App& command, std::string& hierarchy) {
  command.add_option("--hierarchy", hierarchy, "How --engine bvh groups elements: by itself, or as the scene does")
      ->check(one_of("hierarchy", {std::string(engine::automatic), std::string(engine::by_hand)}))
      ->capture_default_str();
}

void add_with(CLI::App& command, std::string& file) {
  auto* const option =
      command.add_option("--with", file, "A Z text that says what the elements are: each is puntos_TIPO");
  for (const char* other : {"--engine", "--hierarchy"})
    if (auto* const named = command.get_option_no_throw(other)) option->excludes(named);
}

std::string without_origins(const engine::EngineRow& engine, std::string_view why) {
  return fmt::format("--engine {}: it knows nothing of the elements that a ray starts on, and {}; expected one of {}",
                     engine.name, why, fmt::join(names(true), ", "));
}

void add_engines(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("engines", "List the engines, and what each promises");
  command->footer(
      "Each technique stands under the head that the literature on acceleration gives it, with its section in the "
      "text\n"
      "that this program follows (A: Ramos, Tema VI), and the engines or the options that have it; durero stats shows\n"
      "what structures cost and save.\n\n" +
      exit_status("they are listed", "the call is bad") + examples({"engines"}));
  command->callback([&status] { status = run(); });
}

}  // namespace durero::cli
