// durero fractal KIND -o OUT.png [--level N] [--size WxH] [--samples N] [--threads N] [--quiet]: a fractal, path
// traced.
#include "durero/render/fractal.hpp"

#include <memory>
#include <optional>

#include "commands.hpp"
#include "description.hpp"
#include "durero/io/file_name.hpp"
#include "durero/io/output_file.hpp"
#include "durero/render/output/tone.hpp"
#include "picture_size.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

struct FractalOptions {
  std::string kind, out, size = "640x400";
  std::uint32_t level = 4, samples = 16;
  std::size_t threads = 0;
  bool quiet = false;
};

constexpr std::string_view menger = "menger", julia = "julia";

render::Fractal fractal_of(const FractalOptions& options) {
  if (options.kind == menger) return distance::MengerSponge{options.level};
  return distance::QuaternionJulia{{-0.2, 0.6, 0.2, 0.2}, 12};
}

int run(const FractalOptions& options) {
  const ThreadLimit limit(options.threads);
  io::require_ending(options.out, io::png_endings, "a fractal");
  io::OutputFile out(options.out);
  std::optional<Progress> progress(std::in_place, options.quiet, "fractal");
  const render::Picture picture = render::draw_fractal(fractal_of(options), *read_size(options.size), options.samples,
                                                       [&](double share) { progress->set_share(share); });
  const std::string bytes = render::encode_png(render::toned(picture, render::Tone::clamp));
  progress.reset();
  out.write(bytes);
  out.commit();
  return 0;
}

}  // namespace

void add_fractal(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("fractal", "Draw a fractal, path traced");
  const auto options = std::make_shared<FractalOptions>();
  command->add_option("KIND", options->kind, "Menger's sponge, or a quaternion Julia set")
      ->check(one_of("fractal", {std::string(menger), std::string(julia)}))
      ->required();
  command->add_option("-o,--output", options->out, "Where the picture goes (PNG)")->required();
  command->add_option("--level", options->level, "Of the sponge: how often its cells are divided")
      ->check(whole_number(0, 12))
      ->capture_default_str();
  command->add_option("--size", options->size, "Width and height in pixels")
      ->check(CLI::Validator(check_size, ""))
      ->capture_default_str();
  command->add_option("--samples", options->samples, "Paths a pixel")
      ->check(whole_number(1, 65536))
      ->capture_default_str();
  add_threads(*command, options->threads);
  add_quiet(*command, options->quiet);
  command->footer(
      "The walk along each ray goes by a lower bound of the distance, so that it passes nothing, and ends where it is\n"
      "within half a pixel. The same call draws the same bytes, whatever the number of threads.\n\n" +
      exit_status("the picture is drawn", "the call is bad, or the file cannot be written") +
      examples({"fractal menger -o menger.png", "fractal julia --size 1280x800 --samples 64 -o julia.png"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
