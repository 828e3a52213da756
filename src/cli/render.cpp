// durero render SCENE -o OUT.png [--engine E]: Algorithm II.1.
#include "durero/render/render.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/scene_file.hpp"
#include "engines.hpp"

namespace durero::cli {
namespace {

struct Options {
  std::string scene, out;
  std::string engine{engine::default_engine};
  std::size_t threads = 0;
};

/// A line that is written over, on a terminal only.
void show(double share) {
  fmt::print(stderr, "\r{:3.0f} %{}", 100 * share, share < 1 ? "" : "\r\033[K");
  std::fflush(stderr);
}

int run(const Options& options) {
  if (!options.out.ends_with(".png"))
    throw std::invalid_argument(fmt::format("{}: not a picture's name; expected OUT.png", options.out));
  const ThreadLimit limit(options.threads);
  const scene::Scene scene = io::read_scene(io::read_source(options.scene));
  const engine::Row& engine = *engine::find(options.engine);
  if (!engine.honours_origins) throw std::invalid_argument(without_origins(engine, "shadow rays start on elements"));
  const auto progress = isatty(STDERR_FILENO) == 1 ? render::Progress(show) : render::Progress();
  const render::Image image = [&] {
    try {
      return render::render(scene, *engine.prepare(scene), progress);
    } catch (const std::domain_error& error) {
      throw std::domain_error(fmt::format("{}: {}", options.scene, error.what()));
    }
  }();
  io::write_file(options.out, render::encode_png(image));
  return 0;
}

}  // namespace

void add_render(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("render", "Draw the scene: camera, Lambert's law, shadows");
  const auto options = std::make_shared<Options>();
  command->add_option("SCENE", options->scene, "Scene file (JSON), with a camera")->required();
  command->add_option("-o,--output", options->out, "The picture, OUT.png")->required();
  add_engine(*command, options->engine);
  add_threads(*command, options->threads);
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
