// durero trace SCENE RAYS [--engine E] [--threads N] [-o OUT]: the first hit of every ray.
#include <fmt/format.h>

#include <algorithm>

#include "commands.hpp"
#include "durero/io/hits_file.hpp"
#include "durero/io/rays_file.hpp"
#include "durero/io/scene_file.hpp"
#include "engines.hpp"

namespace durero::cli {
namespace {

struct Options {
  std::string scene, rays, out = "-";
  std::string engine{engine::default_engine};
  std::size_t threads = 0;  // 0: as many as the machine has
};

int run(const Options& options) {
  const ThreadLimit limit(options.threads);
  const scene::Scene scene = io::read_scene(io::read_source(options.scene));
  const std::vector<io::Ray> rays = io::read_rays(io::read_source(options.rays), scene);
  const engine::Row& engine = *engine::find(options.engine);
  if (!engine.honours_origins && std::ranges::any_of(rays, [](const scene::Query& ray) { return !ray.en.empty(); }))
    throw std::invalid_argument(without_origins(engine, options.rays + " has rays that start on elements"));
  io::write_hits(options.out, engine::first_hits(*engine.prepare(scene), rays), scene);
  return 0;
}

}  // namespace

void add_trace(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("trace", "First hit of every ray");
  const auto options = std::make_shared<Options>();
  command->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
  command->add_option("RAYS", options->rays, "Ray file: text, or .npy (float64, n by 6)")->required();
  add_engine(*command, options->engine);
  add_threads(*command, options->threads);
  command->add_option("-o,--output", options->out, "Where the hits go: JSON lines, or .npy by the name");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
