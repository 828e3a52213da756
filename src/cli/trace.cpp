// durero trace SCENE RAYS [--engine E] [--hierarchy H] [--with FILE] [--threads N] [-o OUT] [--quiet]: the first hit
// of every ray, as rays arrive.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <memory>

#include "commands.hpp"
#include "description.hpp"
#include "durero/io/rays/hits_file.hpp"
#include "durero/io/rays/rays_file.hpp"
#include "engines.hpp"
#include "progress.hpp"
#include "scene_tracer.hpp"

namespace durero::cli {
namespace {

struct TraceOptions {
  std::string scene, rays, out = "-";
  std::string engine{engine::default_engine}, hierarchy{"automatic"}, with;
  std::size_t threads = 0;  // 0: as many as the machine has
  bool quiet = false;
};

/// Sets the share of the file that has been read; without its size, that is not known.
void set_share(Progress& progress, const io::Input& input, std::optional<std::uint64_t> size) {
  const auto left = input.left();
  if (size && left && *size > 0) progress.set_share(1 - static_cast<double>(*left) / static_cast<double>(*size));
}

int run(const TraceOptions& options) {
  const ThreadLimit limit(options.threads);
  io::HitWriter out(options.out);
  const SceneTracer tracer(options.scene, options.engine, options.hierarchy, options.with);
  const scene::Scene& scene = tracer.scene();
  io::Input input(options.rays);
  const auto size = input.left();
  const bool is_in_the_way = options.out == "-" && ::isatty(STDOUT_FILENO) == 1;  // of the hits
  Progress progress(options.quiet || is_in_the_way, "trace", "rays");
  io::RayReader reader(input, scene);
  std::vector<io::Ray> rays;
  while (reader.next(rays)) {
    if (std::ranges::any_of(rays, [](const scene::Query& ray) { return !ray.en.empty(); }))
      tracer.require_origins(options.rays + " has rays that start on elements");
    out.write(engine::first_hits(tracer.engine(), rays), scene);
    progress.add(rays.size());
    set_share(progress, input, size);
  }
  out.commit();
  return 0;
}

}  // namespace

void add_trace(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("trace", "First hit of every ray");
  const auto options = std::make_shared<TraceOptions>();
  command->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
  command->add_option("RAYS", options->rays, "Ray file: text, or .npy (float64, n by 6); - is the standard input")
      ->required();
  add_engine(*command, options->engine);
  add_hierarchy(*command, options->hierarchy);
  add_with(*command, options->with);
  add_threads(*command, options->threads);
  command->add_option("-o,--output", options->out, "Where the hits go: JSON lines, or .npy by the name");
  add_quiet(*command, options->quiet);
  command->footer(
      "A ray is answered when its line has come, so a program can ask one at a time through pipes; memory does not\n"
      "grow with the number of rays. A bad line ends it with status 2: on the standard output the rays before it have\n"
      "been answered, and the file OUT does not appear.\n\n" +
      exit_status("every ray is answered", "the call or a file is bad") +
      examples({"trace demo/still-life.json demo/rays.txt",
                "trace demo/still-life.json demo/rays.txt --engine exact -o hits.jsonl",
                "trace demo/surfaces/torus.json demo/surfaces/rays.txt --with demo/surfaces/torus.tex"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
