// durero environment SCENE -o OUT.png --as KIND [--width N] [--from X,Y,Z] [--engine E] [--max-depth N]: what stands
// around a point, as the pictures of an environment.
#include <fmt/format.h>

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "commands.hpp"
#include "description.hpp"
#include "durero/io/file_name.hpp"
#include "durero/io/output_file.hpp"
#include "durero/render/light/environment_map.hpp"
#include "durero/scene/stage.hpp"
#include "engines.hpp"
#include "scene_tracer.hpp"

namespace durero::cli {
namespace {

struct EnvironmentOptions {
  std::string scene, out, kind, from;
  std::string engine{engine::default_engine};
  std::uint32_t width = 512;
  std::size_t threads = 0;
  std::optional<std::uint32_t> max_depth;
};

/// The most texels of a row: the widest panorama that a scene reads.
constexpr std::uint32_t greatest_width = 8192;

const std::vector<std::string> kinds{"box", "spherical", "equirectangular"};

scene::Surroundings kind_of(std::string_view word) {
  const auto found = std::ranges::find(scene::surroundings_words, word);
  return static_cast<scene::Surroundings>(found - scene::surroundings_words.begin());
}

/// OUT.png, or of a box OUT-px.png, OUT-nx.png, …
std::vector<std::string> names_of_pictures(const std::string& out, scene::Surroundings kind) {
  if (kind != scene::Surroundings::box) return {out};
  std::vector<std::string> names;
  for (const char* face : {"px", "nx", "py", "ny", "pz", "nz"})
    names.push_back(fmt::format("{}-{}.png", std::string_view(out).substr(0, out.size() - 4), face));
  return names;
}

int run(const EnvironmentOptions& options) {
  if (!io::ends_in(options.out, ".png"))
    throw std::invalid_argument(fmt::format("{}: not a picture's name; expected OUT.png", options.out));
  const ThreadLimit limit(options.threads);
  const scene::Surroundings kind = kind_of(options.kind);
  std::vector<std::unique_ptr<io::OutputFile>> files;
  for (const std::string& name : names_of_pictures(options.out, kind))
    files.push_back(std::make_unique<io::OutputFile>(name));
  const SceneTracer tracer(options.scene, options.engine, "automatic", "", {}, Pictures::read);
  tracer.require_origins("shadow rays start on elements");
  const render::PathLimits limits{options.max_depth.value_or(render::depth_of(tracer.scene().stage()))};
  const auto pictures = render::environment_map(tracer.scene(), tracer.engine(), kind, options.width,
                                                point_in(options.from).value_or(glm::dvec3(0)), limits);
  for (std::size_t i = 0; i < files.size(); ++i) files[i]->write(render::encode_png(pictures[i]));
  for (const auto& file : files) file->commit();
  return 0;
}

}  // namespace

void add_environment(CLI::App& app, int& status) {
  auto* command = app.add_subcommand(
      "environment", "Draw all that is around a point, or turn an environment's pictures into those of another kind");
  const auto options = std::make_shared<EnvironmentOptions>();
  command->add_option("SCENE", options->scene, "Scene file (JSON); its elements are seen, or its environment alone")
      ->required();
  command
      ->add_option("-o,--output", options->out,
                   "The picture, OUT.png; of a box six, OUT-px.png, -nx, -py, -ny, -pz and -nz")
      ->required();
  command->add_option("--as", options->kind, "What is drawn")->required()->check(one_of("environment", kinds));
  command->add_option("--width", options->width, "Texels of a row of each picture; without it, 512")
      ->check(whole_number(1, greatest_width));
  command->add_option("--from", options->from, "The point; without it, 0,0,0")->check(CLI::Validator(check_point, ""));
  add_max_depth(*command, options->max_depth);
  add_engine(*command, options->engine);
  add_threads(*command, options->threads);
  command->footer(exit_status("the pictures are written", "the call or the scene is bad") +
                  examples({"environment demo/gallery/everything.json -o around.png --as equirectangular --from 0,1,-4",
                            "environment demo/mirrors.json -o sky.png --as box --width 256"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
