// durero shader SCENE -o OUT.frag|OUT.html: a scene as a fragment shader, or as a page that draws by it.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "commands.hpp"
#include "description.hpp"
#include "durero/io/file_name.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/output_file.hpp"
#include "durero/shader/fragment.hpp"
#include "durero/shader/page.hpp"
#include "file_error.hpp"

namespace durero::cli {
namespace {

struct ShaderOptions {
  std::string scene, out, writes = std::string(shader::shader_outputs[0]);
};

bool is_page(const ShaderOptions& options) {
  if (io::ends_in(options.out, ".html")) {
    if (options.writes == shader::shader_outputs[0]) return true;
    throw std::invalid_argument(
        fmt::format("shader: --writes {}: a page writes whatever it is asked for; expected OUT.frag", options.writes));
  }
  if (io::ends_in(options.out, ".frag")) return false;
  throw std::invalid_argument(
      fmt::format("{}: not a shader's name; expected OUT.frag, or OUT.html for a page", options.out));
}

std::string shader_text(const ShaderOptions& options, bool is_page) {
  const scene::Scene scene = io::read_scene(io::read_source(options.scene));
  const auto* const output = std::ranges::find(shader::shader_outputs, options.writes);
  return naming_file<std::domain_error>(options.scene, [&] {
    return is_page ? shader::shader_page(scene, options.scene.substr(options.scene.rfind('/') + 1))
                   : shader::fragment_shader(
                         scene, static_cast<shader::ShaderOutput>(output - shader::shader_outputs.begin()));
  });
}

int run(const ShaderOptions& options) {
  const bool page = is_page(options);
  io::OutputFile out(options.out);
  out.write(shader_text(options, page));
  out.commit();
  return 0;
}

}  // namespace

void add_shader(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("shader", "Write the scene as a fragment shader, or as a page that draws by it");
  const auto options = std::make_shared<ShaderOptions>();
  command->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
  command
      ->add_option("-o,--output", options->out,
                   "A shader in GLSL ES 3.00, OUT.frag, or a page of the web that opens from a file, OUT.html")
      ->required();
  command
      ->add_option("--writes", options->writes,
                   "What the shader writes for a pixel: its color, the number of its element and whether that is in "
                   "doubt, or the color with doubtful pixels in magenta; color without it")
      ->check(one_of("output", {shader::shader_outputs.begin(), shader::shader_outputs.end()}));
  command->footer(exit_status("it is written", "the call is bad, or the scene is none that a shader can hold") +
                  examples({"shader demo/gallery/shader.json -o shader.html",
                            "shader demo/gallery/shader.json -o shader.frag --writes answer"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
