// durero distance SCENE POINTS [--of ELEMENT] [--threads N] [-o OUT]: how far each point is from the scene, and what is
// nearest to it.
#include <array>
#include <memory>
#include <vector>

#include "commands.hpp"
#include "description.hpp"
#include "durero/distance/distances.hpp"
#include "durero/io/file_name.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/rays/points_file.hpp"
#include "durero/io/rays/proximities_file.hpp"
#include "durero/text/shown.hpp"

namespace durero::cli {
namespace {

struct DistanceOptions {
  std::string scene, points, of, out = "-";
  std::size_t threads = 0;  // 0: as many as the machine has
};

constexpr std::array<std::string_view, 5> endings{".jsonl", ".ndjson", ".json", ".txt", ".npy"};

/// The element that is asked about; nothing where the whole scene is.
std::optional<scene::ElementRef> asked_element(const DistanceOptions& options, const scene::Scene& scene) {
  if (options.of.empty()) return std::nullopt;
  const auto element = scene.find(options.of);
  if (!element)
    throw io::FileError("--of " + text::shown(options.of), "no such element", "expected one of " + options.scene);
  return element;
}

/// The answers, and of one closed element the distances with their sign.
struct Proximities {
  std::vector<scene::Proximity> answers;
  std::vector<std::optional<double>> with_sign;
};

Proximities answered(const scene::Scene& scene, std::optional<scene::ElementRef> element,
                     const std::vector<glm::dvec3>& points) {
  Proximities found{std::vector<scene::Proximity>(points.size()), std::vector<std::optional<double>>(points.size())};
  if (!element) {
    distance::Distances(scene).nearest(points, found.answers);
    return found;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    found.answers[i] = distance::nearest_of(scene, *element, points[i]);
    found.with_sign[i] = distance::signed_distance(scene, *element, points[i]);
  }
  return found;
}

int run(const DistanceOptions& options) {
  const ThreadLimit limit(options.threads);
  io::require_ending(options.out, endings, "distances");
  io::OutputFile out(options.out);
  const scene::Scene scene = io::read_scene(io::read_source(options.scene));
  const auto element = asked_element(options, scene);
  const std::vector<glm::dvec3> points = io::read_points(io::read_source(options.points));
  const Proximities found = answered(scene, element, points);
  if (io::ends_in(options.out, ".npy")) {
    out.write(io::proximities_npy(found.answers, scene));
  } else {
    std::string text;
    for (std::size_t i = 0; i < points.size(); ++i)
      text.append(io::proximity_text(i, found.answers[i], scene, found.with_sign[i])) += '\n';
    out.write(text);
  }
  out.commit();
  return 0;
}

}  // namespace

void add_distance(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("distance", "How far points are from the scene, and what is nearest");
  const auto options = std::make_shared<DistanceOptions>();
  command->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
  command
      ->add_option("POINTS", options->points,
                   "Points: text, x y z a line, or .npy (float64, n by 3); - is the standard input")
      ->required();
  command->add_option("--of", options->of, "Of this element alone; of a sphere with the sign, too: negative inside");
  add_threads(*command, options->threads);
  command->add_option("-o,--output", options->out, "Where the distances go: JSON lines, or .npy by the name");
  command->footer(
      "Each number is the exact one, rounded once. `elementos` are all elements that have the distance, exact ties "
      "too,\n"
      "and `nearest` is the nearest point: of many, as from the centre of a sphere, the first by x, then y, then "
      "z.\n\n" +
      exit_status("every point is answered", "the call or a file is bad") +
      examples({"distance demo/still-life.json demo/points.txt",
                "distance demo/still-life.json demo/points.txt --of apple -o distances.npy"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
