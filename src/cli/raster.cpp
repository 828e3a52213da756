// durero raster TECHNIQUE SCENE -o OUT.png: a picture by a raster's technique, the picture by rays, and their
// difference.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "description.hpp"
#include "durero/io/file_name.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/raster/difference.hpp"
#include "durero/render/output/tone.hpp"
#include "durero/scene/camera.hpp"
#include "engines.hpp"
#include "file_error.hpp"
#include "picture_size.hpp"
#include "raster_techniques.hpp"
#include "render_options.hpp"

namespace durero::cli {
namespace {

/// The picture whose pixels are the means of finer × finer ones.
render::Picture means(const render::Picture& fine, std::uint32_t finer) {
  render::Picture picture({fine.resolution.width / finer, fine.resolution.height / finer});
  for (std::uint32_t y = 0; y < fine.resolution.height; ++y)
    for (std::uint32_t x = 0; x < fine.resolution.width; ++x)
      picture.rgb[std::size_t(y / finer) * picture.resolution.width + x / finer] +=
          fine.rgb[std::size_t(y) * fine.resolution.width + x] / double(finer * finer);
  return picture;
}

/// Pictures of one size side by side, with a white line of four pixels between them.
render::Image beside(std::initializer_list<const render::Image*> images) {
  constexpr std::uint32_t line = 4;
  const auto [width, height] = (*images.begin())->resolution;
  const auto count = static_cast<std::uint32_t>(images.size());
  render::Image all({count * width + (count - 1) * line, height});
  std::ranges::fill(all.rgb, std::uint8_t{255});
  std::uint32_t left = 0;
  for (const render::Image* image : images) {
    for (std::uint32_t y = 0; y < height; ++y)
      std::copy_n(image->rgb.begin() + std::ptrdiff_t(3) * y * width, std::ptrdiff_t(3) * width,
                  all.rgb.begin() + std::ptrdiff_t(3) * (std::ptrdiff_t(y) * all.resolution.width + left));
    left += width + line;
  }
  return all;
}

/// A subcommand: its techniques, its own options, and a call of it.
struct RasterCommand {
  const char* name;
  const char* what;
  Technique technique;
  Drawing drawing;  ///< null where there is none
  void (*add_options)(CLI::App&, RasterOptions&);
  const char* example;
};

/// The names of the pictures: OUT.png, OUT-rays.png and OUT-difference.png, or OUT.png alone.
std::vector<std::string> names_of_pictures(const RasterOptions& options) {
  if (options.beside) return {options.out};
  const std::string_view stem = std::string_view(options.out).substr(0, options.out.size() - 4);
  return {options.out, fmt::format("{}-rays.png", stem), fmt::format("{}-difference.png", stem)};
}

/// A scene that is drawn, and its name in errors.
struct RasterWork {
  const RasterOptions& options;
  const RasterCommand& row;
  const SceneTracer tracer;
  const scene::Resolution size;

  RasterWork(const RasterOptions& of, const RasterCommand& by)
      : options(of),
        row(by),
        tracer(of.scene, of.engine, "automatic", "", read_size(of.size), Pictures::read),
        size(tracer.scene().stage().resolution.value_or(scene::default_resolution)) {
    tracer.require_origins("shadow rays start on elements");
    tracer.require_tables("durero raster");
  }

  /// Calls draw(), and adds the name of the scene to its errors.
  template <class Draw>
  auto in_words(const Draw& draw) const {
    return naming_file<std::domain_error>(options.scene, draw);
  }
};

int draw_areas(const RasterOptions& options, const RasterCommand& row) {
  io::OutputFile file(options.out);
  const RasterWork work(options, row);
  const std::string drawing = work.in_words([&] { return row.drawing(work.tracer, work.size); });
  file.write(drawing);
  file.commit();
  return 0;
}

int draw_pictures(const RasterOptions& options, const RasterCommand& row) {
  std::vector<std::unique_ptr<io::OutputFile>> files;
  for (const std::string& name : names_of_pictures(options)) files.push_back(std::make_unique<io::OutputFile>(name));
  const RasterWork work(options, row);
  const std::uint32_t finer = options.finer();
  const RasterResult result = work.in_words([&] {
    return row.technique(options, work.tracer, {work.size.width * finer, work.size.height * finer});
  });
  const render::Image own = render::toned(means(result.picture, finer), render::Tone::clamp),
                      rays = render::toned(means(result.rays, finer), render::Tone::clamp);
  const raster::PictureDifference apart = raster::difference(own, rays);
  std::vector<render::Image> images{own, rays, apart.image};
  if (options.beside) images = {beside({&own, &rays, &apart.image})};
  for (std::size_t i = 0; i < files.size(); ++i) files[i]->write(render::encode_png(images[i]));
  for (const auto& file : files) file->commit();
  io::print(fmt::format("{}: {}; {} of {} pixels differ from rays, by at most {} of 255\n", row.name, result.figures,
                        apart.pixels, std::uint64_t(work.size.width) * work.size.height, apart.greatest));
  return 0;
}

int run(const RasterOptions& options, const RasterCommand& row) {
  if (options.finer() * options.finer() != options.samples)
    throw std::invalid_argument(
        fmt::format("raster {}: --samples {}: no square number; expected 1, 4, 9, …", row.name, options.samples));
  const ThreadLimit limit(options.threads);
  if (row.drawing != nullptr && io::ends_in(options.out, ".svg")) return draw_areas(options, row);
  if (io::ends_in(options.out, ".png")) return draw_pictures(options, row);
  throw std::invalid_argument(fmt::format("{}: not a picture's name; expected OUT.png{}", options.out,
                                          row.drawing != nullptr ? " or OUT.svg" : ""));
}

void add_map(CLI::App& command, RasterOptions& options) {
  command.add_option("--map", options.map, "Texels of a row of a depth map; without it, 1024")
      ->check(whole_number(1, 8192));
}

void add_depth_map_options(CLI::App& command, RasterOptions& options) {
  add_map(command, options);
  command.add_option("--bias", options.bias, "What is taken off a distance before the test; without it, texel")
      ->check(one_of("bias", {"none", "texel"}));
}

void add_projected_options(CLI::App& command, RasterOptions& options) {
  command.add_option("--picture", options.picture, "The picture that the first light throws, a PNG or JPEG file")
      ->required();
  command.add_option("--towards", options.towards, "The point that it throws it at; without it, that of the camera")
      ->check(CLI::Validator(check_point, ""));
  command.add_option("--angle", options.height, "The angle of the picture's height, in degrees; without it, 60")
      ->check(number(1, 170));
  add_map(command, options);
}

void add_transparent_options(CLI::App& command, RasterOptions& options) {
  command
      .add_option("--order", options.order,
                  "In which order transparent polygons are drawn: far ones first, or by name; without it, depth")
      ->check(one_of("order", {"depth", "names"}));
}

void add_mirror_options(CLI::App& command, RasterOptions& options) {
  command.add_option("--mirror", options.mirror, "The name of the flat element that is the mirror")->required();
  add_max_depth(command, options.max_depth);
}

void add_no_options(CLI::App&, RasterOptions&) {}

constexpr std::array commands{
    RasterCommand{"shadows", "Shadows as polygons: each polygon projected on each other one", shadows_technique,
                  shadows_drawing, add_no_options, "raster shadows demo/gallery/raster-blocks.json -o blocks.png"},
    RasterCommand{"weiler", "Lit polygons: what lights do not see is cut away (Weiler, Atherton and Greenberg)",
                  weiler_technique, weiler_drawing, add_no_options,
                  "raster weiler demo/gallery/raster-blocks.json -o blocks.svg"},
    RasterCommand{"depth-map", "Shadows by a Z-buffer of each light", depth_map_technique, nullptr,
                  add_depth_map_options,
                  "raster depth-map demo/gallery/raster-blocks.json -o blocks.png --map 256 --bias none"},
    RasterCommand{"projected", "A light that throws a picture", projected_technique, nullptr, add_projected_options,
                  "raster projected demo/gallery/raster-blocks.json -o blocks.png --picture demo/gallery/slide.png"},
    RasterCommand{"transparent", "Transparent polygons drawn over what lies behind them", transparent_technique,
                  nullptr, add_transparent_options, "raster transparent demo/gallery/raster-sheets.json -o sheets.png"},
    RasterCommand{"mirror", "A flat mirror by a second camera behind it", mirror_technique, nullptr, add_mirror_options,
                  "raster mirror demo/gallery/raster-mirror.json -o mirror.png --mirror glass"}};

void add_technique(CLI::App& raster, const RasterCommand& row, int& status) {
  auto* command = raster.add_subcommand(row.name, row.what);
  const auto options = std::make_shared<RasterOptions>();
  command->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
  command
      ->add_option("-o,--output", options->out,
                   fmt::format("The picture, OUT.png; also written are OUT-rays.png, by rays, and OUT-difference.png{}",
                               row.drawing != nullptr ? "; or a drawing of areas alone, OUT.svg" : ""))
      ->required();
  command->add_flag("--beside", options->beside, "Write one picture: the three of them side by side");
  add_size(*command, options->size);
  command
      ->add_option("--samples", options->samples,
                   "How many points of each pixel it is the mean of: a square number, 1 without it")
      ->check(whole_number(1, 256));
  row.add_options(*command, *options);
  add_engine(*command, options->engine);
  add_threads(*command, options->threads);
  command->footer(exit_status("the pictures are written", "the call is bad, or the technique does not draw the scene") +
                  examples({row.example}));
  command->callback([options, &row, &status] { status = run(*options, row); });
}

}  // namespace

void add_raster(CLI::App& app, int& status) {
  auto* raster = app.add_subcommand("raster", "Draw the scene by projecting polygons, and compare with rays");
  raster->require_subcommand(1);
  for (const RasterCommand& row : commands) add_technique(*raster, row, status);
  raster->footer(examples({commands[0].example, commands[4].example}));
}

}  // namespace durero::cli
