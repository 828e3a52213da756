#include "render_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "commands.hpp"
#include "durero/io/file_name.hpp"
#include "durero/render/bundle/cones.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/render/sample/sampling.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/shown.hpp"
#include "engines.hpp"
#include "numbers.hpp"
#include "picture_size.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

/// The greatest number of points of a pixel that takes as many as it needs, where the call names none.
constexpr std::uint32_t most_samples = 1024;

std::string check_crop(const std::string& text) {
  const auto crop = numbers_in<4>(text, ',', read_side);
  if (crop && (*crop)[2] > 0 && (*crop)[3] > 0) return "";
  return fmt::format("{}: no rectangle; expected X,Y,W,H, whole numbers up to {}, W and H from 1", text, greatest_side);
}

/// A check for a number strictly between two.
CLI::Validator number_between(double low, double high) {
  const auto check = [=](const std::string& text) -> std::string {
    const std::optional<double> value = io::read_number(text);
    if (value && low < *value && *value < high) return "";
    return fmt::format("{}: no number from {} to {}, neither of them; expected one", text, low, high);
  };
  return {check, fmt::format("above {}, below {}", low, high)};
}

template <std::size_t count>
std::vector<std::string> words(const std::array<std::string_view, count>& names) {
  return {names.begin(), names.end()};
}

/// The value with that name; the first one without a name.
template <class Value, std::size_t count>
Value value_of_name(const std::array<std::string_view, count>& names, const std::string& name) {
  if (name.empty()) return Value{};
  return static_cast<Value>(std::ranges::find(names, name) - names.begin());
}

void add_size_options(CLI::App& command, RenderOptions& options) {
  add_size(command, options.size);
  command.add_option("--crop", options.crop, "These pixels of the picture alone: upper left one, width and height")
      ->check(CLI::Validator(check_crop, ""));
}

void add_depth_options(CLI::App& command, RenderOptions& options) {
  command
      .add_option("--integrator", options.integrator,
                  "Whitted's algorithm, or paths: light that comes by way of all things; without it, whitted")
      ->check(one_of("integrator", words(render::integrator_names)));
  command
      .add_option("--shadows", options.shadows, "Glass hides a light as stone does, or colours it; without it, opaque")
      ->check(one_of("rule of shadows", words(render::shadow_rule_names)));
  add_max_depth(command, options.max_depth);
  command
      .add_option("--min-weight", options.min_weight,
                  "Do not follow rays that count for less than this share of a pixel; says how far rays were followed")
      ->check(number(0, 1));
}

void add_sample_options(CLI::App& command, RenderOptions& options) {
  command
      .add_option("--sampling", options.sampling,
                  "Points of a pixel that rays go through: a grid, one in each square of a grid, a scrambled net, of "
                  "one as many as the pixels around ask for, each by itself, or as many as it takes; without it, grid, "
                  "and net for paths")
      ->check(one_of("sampling", words(render::sampling_names)));
  command
      .add_option("--samples", options.samples,
                  fmt::format("How many: in squares a square number; 1 without it; of allotted and statistical the "
                              "most, {} without it; of a "
                              "preview how many passes",
                              most_samples))
      ->check(whole_number(1, render::greatest_samples));
  command.add_option("--seed", options.seed, "Chooses among the random numbers; without it, 0")
      ->check(whole_number(0, std::numeric_limits<std::uint32_t>::max()));
  command
      .add_option("--width", options.width, "Of statistical: how far off a linear component may be; without it, 0.05")
      ->check(number_between(0, 1));
  command
      .add_option("--confidence", options.confidence,
                  "Of statistical: how likely a pixel is no farther off; without it, 0.95")
      ->check(number_between(0, 1));
}

void add_file_options(CLI::App& command, RenderOptions& options) {
  command
      .add_option("--tone", options.tone,
                  "What becomes of linear colours in OUT.png: above 1 cut, divided by the greatest one, or c/(1 + c); "
                  "without it, clamp")
      ->check(one_of("tone", words(render::tone_names)));
  command.add_flag("--aov", options.aov, "Write depth, normal, element and deciding level into OUT.exr besides");
}

/// The points of a pixel: without a word for them a grid, whose bytes are simple to know, or for paths a net, which has
/// no bias.
render::Sampling sampling_of(const RenderOptions& options) {
  if (options.sampling.empty() && options.integrator == render::integrator_names[1]) return render::Sampling::net;
  return value_of_name<render::Sampling>(render::sampling_names, options.sampling);
}

/// A word as a shell reads it.
std::string shell_word(const std::string& text) {
  const auto plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
           std::string_view("_./:@%+=,-").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::ranges::all_of(text, plain)) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

/// An option of the call that is of rays that are lines alone; empty without one.
std::string option_of_lines(const RenderOptions& options) {
  if (options.preview) return "--preview";
  if (options.min_weight) return fmt::format("--min-weight {}", *options.min_weight);
  if (!options.sampling.empty()) return "--sampling " + options.sampling;
  return options.samples ? fmt::format("--samples {}", *options.samples) : "";
}

std::string name_without_folder(const std::string& path) {
  return shell_word(text::escaped(path.substr(path.rfind('/') + 1)));
}

}  // namespace

void add_size(CLI::App& command, std::string& size) {
  command.add_option("--size", size, "Width and height in pixels; without it, the scene's, or else 640x360")
      ->check(CLI::Validator(check_size, ""));
}

void add_render_options(CLI::App& command, RenderOptions& options) {
  command.add_option("SCENE", options.scene, "Scene file (JSON), with a camera")->required();
  command.add_option("-o,--output", options.out, "The picture, OUT.png, or OUT.exr in linear light")->required();
  add_size_options(command, options);
  add_depth_options(command, options);
  add_sample_options(command, options);
  add_ray_options(command, options.wide);
  add_file_options(command, options);
  auto* const preview =
      command.add_flag("--preview", options.preview,
                       "Write the picture after one ray a pixel, and again after each further one, until interrupted");
  preview->excludes(command.get_option("--sampling"));
  add_engine(command, options.engine);
  add_hierarchy(command, options.hierarchy);
  add_with(command, options.with);
  command.get_option("--aov")->excludes(command.get_option("--with"));
  add_threads(command, options.threads);
  add_quiet(command, options.quiet);
}

void check_together(const RenderOptions& options) {
  const auto refuse = [](bool wrong, const std::string& what) {
    if (wrong) throw std::invalid_argument(what);
  };
  refuse(!io::ends_in(options.out, ".png") && !options.is_exr(),
         fmt::format("{}: not a picture's name; expected OUT.png or OUT.exr", options.out));
  refuse(options.is_exr() && !options.tone.empty(),
         fmt::format("--tone {}: {} holds linear light; expected OUT.png", options.tone, options.out));
  refuse(options.aov && !options.is_exr(),
         fmt::format("--aov: {} has no such channels; expected OUT.exr", options.out));
  refuse(options.width && !options.is_statistical(), "--width: of one sampling alone; expected --sampling statistical");
  refuse(options.confidence && !options.is_statistical(),
         "--confidence: of one sampling alone; expected --sampling statistical");
  refuse(options.min_weight && options.integrator == render::integrator_names[1],
         "--min-weight: of one integrator alone; expected --integrator whitted");
  refuse(options.wide.kind() != RayKind::lines && options.integrator == render::integrator_names[1],
         "--rays: of one integrator alone; expected --integrator whitted");
  refuse(options.wide.kind() != RayKind::lines && options.shadows == render::shadow_rule_names[1],
         "--shadows coloured: of rays that are lines alone; expected no --rays");
  check_together(options.wide, option_of_lines(options));
  if (options.preview || !options.samples) return;
  const double side = std::sqrt(*options.samples);
  const render::Sampling sampling = sampling_of(options);
  const bool in_squares = sampling == render::Sampling::grid || sampling == render::Sampling::stratified;
  refuse(
      in_squares && side != std::floor(side),
      fmt::format("--samples {}: no square number; expected 1, 4, 9, … or --sampling statistical", *options.samples));
  refuse(options.is_as_needed() && *options.samples < render::least_samples,
         fmt::format("--samples {}: too few to tell anything; expected {} or more with --sampling {}", *options.samples,
                     render::least_samples, options.sampling));
}

render::RenderSettings frame_of(const RenderOptions& options) {
  render::RenderSettings frame;
  frame.size = read_size(options.size);
  if (const auto crop = numbers_in<4>(options.crop, ',', read_side))
    frame.crop = {(*crop)[0], (*crop)[1], {(*crop)[2], (*crop)[3]}};
  frame.max_depth = options.max_depth;
  frame.min_weight = options.min_weight.value_or(0);
  frame.integrator = value_of_name<render::Integrator>(render::integrator_names, options.integrator);
  frame.shadows = value_of_name<render::ShadowRule>(render::shadow_rule_names, options.shadows);
  frame.samples.sampling = sampling_of(options);
  frame.samples.most = options.samples.value_or(options.is_as_needed() ? most_samples : 1);
  frame.samples.seed = options.seed.value_or(0);
  frame.samples.width = options.width.value_or(frame.samples.width);
  frame.samples.confidence = options.confidence.value_or(frame.samples.confidence);
  return frame;
}

render::Tone tone_of(const RenderOptions& options) {
  return value_of_name<render::Tone>(render::tone_names, options.tone);
}

scene::Resolution size_of(const RenderOptions& options, const scene::Stage& stage) {
  return frame_of(options).size.value_or(stage.resolution.value_or(render::default_resolution));
}

std::vector<render::Note> notes_of(const RenderOptions& options, const scene::Stage& stage,
                                   std::optional<std::uint32_t> passes) {
  const render::RenderSettings frame = frame_of(options);
  const scene::Resolution size = size_of(options, stage);
  std::string call = "durero render " + name_without_folder(options.scene);
  if (!options.with.empty()) call += " --with " + name_without_folder(options.with);
  call += fmt::format(" --size {}x{}", size.width, size.height);
  if (const auto& crop = frame.crop; crop && crop->size != size)
    call += fmt::format(" --crop {},{},{},{}", crop->x, crop->y, crop->size.width, crop->size.height);
  if (frame.integrator != render::Integrator{}) call += " --integrator " + options.integrator;
  if (frame.shadows != render::ShadowRule{}) call += " --shadows " + options.shadows;
  call += fmt::format(" --max-depth {}", frame.max_depth.value_or(render::depth_of(stage, frame.integrator)));
  if (frame.min_weight > 0) call += fmt::format(" --min-weight {}", frame.min_weight);
  const render::Samples& samples = frame.samples;
  if (passes) {
    call += fmt::format(" --preview --samples {}", *passes);
  } else if (samples.sampling != render::Sampling::grid || samples.most != 1) {
    call +=
        fmt::format(" --sampling {} --samples {}", render::sampling_names[std::size_t(samples.sampling)], samples.most);
    if (options.is_statistical()) call += fmt::format(" --width {} --confidence {}", samples.width, samples.confidence);
  }
  if (samples.seed != 0) call += fmt::format(" --seed {}", samples.seed);
  const double spread = options.wide.spread.value_or(1);
  if (options.wide.kind() == RayKind::cones && !render::cones_are_rays(stage, spread))
    call += fmt::format(" --rays cones --spread {}", spread);
  if (options.wide.kind() == RayKind::pencils) call += " --rays pencils";
  if (tone_of(options) != render::Tone::clamp) call += " --tone " + options.tone;
  if (options.aov) call += " --aov";
  return {{"Software", std::string("Durero ") + DURERO_VERSION}, {"Comment", call}};
}

}  // namespace durero::cli
