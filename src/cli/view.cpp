// durero view SCENE [--engine E] [--hierarchy H] [--with FILE] [--threads N]: the scene in the terminal, to be turned
// and picked from.
#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "description.hpp"
#include "durero/io/standard_output.hpp"
#include "engines.hpp"
#include "scene_tracer.hpp"
#include "terminal_view.hpp"

namespace durero::cli {
namespace {

int run(const ViewOptions& options) {
  const ThreadLimit limit(options.threads);
  io::print(camera_line(show_in_terminal(options)));
  return 0;
}

}  // namespace

void add_view(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("view", "Show the scene in the terminal: turn it, and pick elements");
  const auto options = std::make_shared<ViewOptions>();
  command->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
  add_engine(*command, options->engine);
  add_hierarchy(*command, options->hierarchy);
  add_with(*command, options->with);
  add_threads(*command, options->threads);
  command->footer(
      fmt::format("Keys: {}.\n", view_keys()) +
      "A click, or Enter for the middle, tells the elements that are met there first, the exact t in forty\n"
      "digits, and the point. At the end it prints the camera, as a scene file has it.\n\n" +
      exit_status("it was shown", "the call or the scene is bad, or there is no terminal") +
      examples({"view demo/still-life.json", "view demo/surfaces/torus.json --with demo/surfaces/torus.tex"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
