// durero render SCENE -o OUT.png [--engine E] [--hierarchy H] [--with FILE] [--size WxH] [--crop X,Y,W,H]
// [--max-depth N] [--min-weight W]: Algorithm II.1.
#include "durero/render/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include "commands.hpp"
#include "description.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/standard_output.hpp"
#include "engines.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

struct RenderOptions {
  std::string scene, out, size, crop;
  std::string engine{engine::default_engine}, hierarchy{"automatic"}, with;
  std::size_t threads = 0;
  std::optional<std::uint32_t> max_depth;
  std::optional<double> min_weight;
  bool quiet = false;
};

/// The most pixels of a side, as in scene files.
constexpr std::uint32_t greatest_side = 65535;

/// As many whole numbers, with separators between them; nothing where the text is no such.
template <std::size_t count>
std::optional<std::array<std::uint32_t, count>> numbers_in(std::string_view text, char separator) {
  std::array<std::uint32_t, count> numbers{};
  for (std::uint32_t& number : numbers) {
    const bool is_last = &number == &numbers.back();
    const std::size_t end = is_last ? text.size() : text.find(separator);
    const auto value = read_whole_number(text.substr(0, end));
    if (end == text.npos || !value || *value > greatest_side) return std::nullopt;
    number = static_cast<std::uint32_t>(*value);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return numbers;
}

std::string check_size(const std::string& text) {
  const auto size = numbers_in<2>(text, 'x');
  if (size && (*size)[0] > 0 && (*size)[1] > 0) return "";
  return fmt::format("{}: no size; expected WxH, two whole numbers from 1 to {}", text, greatest_side);
}

std::string check_crop(const std::string& text) {
  const auto crop = numbers_in<4>(text, ',');
  if (crop && (*crop)[2] > 0 && (*crop)[3] > 0) return "";
  return fmt::format("{}: no rectangle; expected X,Y,W,H, whole numbers up to {}, W and H from 1", text, greatest_side);
}

render::Frame frame_of(const RenderOptions& options) {
  render::Frame frame;
  if (const auto size = numbers_in<2>(options.size, 'x')) frame.size = {(*size)[0], (*size)[1]};
  if (const auto crop = numbers_in<4>(options.crop, ','))
    frame.crop = {(*crop)[0], (*crop)[1], {(*crop)[2], (*crop)[3]}};
  frame.max_depth = options.max_depth;
  frame.min_weight = options.min_weight.value_or(0);
  return frame;
}

std::string reach_text(const render::Reach& reach) {
  const auto pixels = static_cast<double>(reach.pixels);
  return fmt::format("mean depth {:.3f} of {}, {:.3f} rays a pixel; left out: at most {:.3g} of a linear component\n",
                     static_cast<double>(reach.depths) / pixels, reach.max_depth,
                     static_cast<double>(reach.rays) / pixels, reach.left_out);
}

int run(const RenderOptions& options) {
  if (!options.out.ends_with(".png"))
    throw std::invalid_argument(fmt::format("{}: not a picture's name; expected OUT.png", options.out));
  const ThreadLimit limit(options.threads);
  io::OutputFile out(options.out);
  const Asked asked =
      asked_of(options.scene, options.engine, options.hierarchy, options.with, frame_of(options).size, Pictures::read);
  const scene::Scene& scene = asked.scene();
  asked.require_origins("shadow rays start on elements");
  Progress progress(options.quiet, "render");
  render::Reach reach;
  const render::Image image = [&] {
    try {
      const auto show = [&](double share) { progress.set_share(share); };
      return render::render(scene, asked.engine(), show, frame_of(options), &reach);
    } catch (const std::domain_error& error) {
      throw std::domain_error(fmt::format("{}: {}", options.scene, error.what()));
    } catch (const std::out_of_range&) {
      const scene::Resolution size =
          frame_of(options).size.value_or(scene.stage().resolution.value_or(render::default_resolution));
      throw std::runtime_error(fmt::format("render: --crop {}: it is not inside the picture; expected pixels of {}x{}",
                                           options.crop, size.width, size.height));
    }
  }();
  out.write(render::encode_png(image));
  if (options.min_weight) io::print(reach_text(reach));
  out.commit();
  return 0;
}

}  // namespace

void add_render(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("render", "Draw the scene: camera, lights and shadows, mirrors and glass");
  const auto options = std::make_shared<RenderOptions>();
  command->add_option("SCENE", options->scene, "Scene file (JSON), with a camera")->required();
  command->add_option("-o,--output", options->out, "The picture, OUT.png")->required();
  command->add_option("--size", options->size, "Width and height in pixels; without it, the scene's, or else 640x360")
      ->check(CLI::Validator(check_size, ""));
  command->add_option("--crop", options->crop, "These pixels of the picture alone: upper left one, width and height")
      ->check(CLI::Validator(check_crop, ""));
  command
      ->add_option("--max-depth", options->max_depth,
                   "Rays in a row from mirror to mirror; without it, the scene's, or else what its materials need")
      ->check(whole_number(1, scene::greatest_depth));
  command
      ->add_option("--min-weight", options->min_weight,
                   "Do not follow rays that count for less than this share of a pixel; says how far rays were followed")
      ->check(number(0, 1));
  add_engine(*command, options->engine);
  add_hierarchy(*command, options->hierarchy);
  add_with(*command, options->with);
  add_threads(*command, options->threads);
  add_quiet(*command, options->quiet);
  command->footer(exit_status("the picture is written", "the call or the scene is bad") +
                  examples({"render demo/still-life.json -o still-life.png",
                            "render demo/still-life.json -o middle.png --size 1920x1080 --crop 480,270,960,540",
                            "render demo/surfaces/torus.json -o torus.png --with demo/surfaces/torus.tex"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
