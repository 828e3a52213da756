// durero voxelise SCENE --depth D [--solid] [-o OUT] [--quiet]: the scene as a mosaic of cubes.
#include <fmt/format.h>
#include <unistd.h>

#include <memory>

#include "commands.hpp"
#include "description.hpp"
#include "durero/accel/mosaic.hpp"
#include "durero/conform/format_versions.hpp"
#include "durero/io/file_name.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/output_file.hpp"
#include "durero/text/shown.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

using accel::Mosaic;
using accel::Voxel;

struct VoxeliseOptions {
  std::string scene, out = "-";
  int depth = 0;
  bool is_solid = false, quiet = false;
};

/// The size of the chunks in which text is written.
constexpr std::size_t chunk = std::size_t{1} << 20;

/// Writes the types for which there may be more cubes than those with points of them.
void write_conservative(io::json::Writer& out, const Mosaic& mosaic) {
  out.key("conservative").begin_array();
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    const auto is_of_type = [](scene::ElementRef e) { return e.tipo == Shape::tipo; };
    if (!accel::is_exact_in_mosaics(Shape::tipo) && std::ranges::any_of(mosaic.contents().elements, is_of_type))
      out.value(Shape::word);
  });
  out.end_array();
}

void write_head(io::json::Writer& out, const VoxeliseOptions& options, const scene::Scene& scene,
                const Mosaic& mosaic) {
  const surface::Box root = mosaic.finest().whole();
  write_version(out.begin_object(), conform::mosaic_format);
  out.member("file", text::escaped(options.scene)).member("elementos", std::uint64_t{scene.size()});
  out.new_line().member("filling", options.is_solid ? "solid" : "surface");
  out.member("depth", std::uint64_t(options.depth)).key("cube").begin_object();
  out.member("low", root.low).member("side", root.high.x - root.low.x).end_object();
  out.new_line().key("apart").begin_array();
  for (const scene::ElementRef e : mosaic.contents().apart) out.value(scene.name(e).name());
  write_conservative(out.end_array(), mosaic);
  out.new_line().key("voxels").begin_array();
}

void write_names(io::json::Writer& out, const char* key, std::span<const std::uint32_t> numbers,
                 const scene::Scene& scene, const Mosaic& mosaic) {
  if (numbers.empty()) return;
  out.key(key).begin_array();
  for (const std::uint32_t number : numbers) out.value(scene.name(mosaic.contents().elements[number]).name());
  out.end_array();
}

int run(const VoxeliseOptions& options) {
  io::require_ending(options.out, io::json_endings, "a mosaic");
  io::OutputFile file(options.out);
  const scene::Scene scene = io::read_scene(io::read_source(options.scene));
  const Mosaic mosaic(scene, options.depth, options.is_solid ? accel::Filling::solid : accel::Filling::surface);
  const bool is_in_the_way = options.out == "-" && ::isatty(STDOUT_FILENO) == 1;  // of the cubes
  Progress progress(options.quiet || is_in_the_way, "voxelise", "cubes");
  std::string text;
  io::json::Writer out(text);
  write_head(out, options, scene, mosaic);
  std::uint64_t surface = 0, inside = 0;
  mosaic.for_each([&](const Voxel& voxel) {
    const auto side = static_cast<std::uint64_t>(mosaic.side(voxel));
    (voxel.surface.empty() ? inside : surface) += side * side * side;
    out.new_line().begin_object().member("code", voxel.code);
    write_names(out, "surface", voxel.surface, scene, mosaic);
    write_names(out, "inside", voxel.inside, scene, mosaic);
    out.end_object();
    progress.add();
    if (text.size() < chunk) return;
    file.write(text);
    text.clear();
  });
  out.end_array().new_line().key("volume").begin_object().member("surface", surface).member("inside", inside);
  out.end_object().end_object();
  file.write(text + "\n");
  file.commit();
  return 0;
}

}  // namespace

void add_voxelise(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("voxelise", "The scene as a mosaic of cubes");
  const auto options = std::make_shared<VoxeliseOptions>();
  command->add_option("SCENE", options->scene, "Scene file (JSON); - is the standard input")->required();
  command->add_option("--depth", options->depth, "The cube about the scene is halved so often")
      ->required()
      ->check(whole_number(0, Mosaic::deepest));
  command->add_flag("--solid", options->is_solid, "The cubes inside spheres too");
  command->add_option("-o,--output", options->out, "Where the mosaic goes (JSON); without it, the standard output");
  add_quiet(*command, options->quiet);
  command->footer(
      "A cube is of the mosaic where the surface of an element has a point in it, and is named by its octal code: a\n"
      "digit of each level, whose bits 1, 2 and 4 tell the upper halves along x, y and z. With --solid cubes are "
      "there\n"
      "too that lie inside a sphere, the greatest that no surface has a point in; other surfaces enclose nothing. Of\n"
      "spheres and triangles it is decided exactly. Of the types that are named as conservative, none of the cubes is\n"
      "missing, and some may be there that only lie close by. Elements without a bound, such as planes, are "
      "apart.\n\n" +
      exit_status("the mosaic is written", "the call or the scene is bad") +
      examples({"voxelise demo/still-life.json --depth 5",
                "voxelise demo/still-life.json --depth 6 --solid -o mosaic.json"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
