// durero convert FROM TO, import FILE -o SCENE and export SCENE -o FILE: scene formats, by file name. durero import
// FOLDER --survey: which files of a folder can be read.
#include <fmt/format.h>

#include <optional>

#include "by_text.hpp"
#include "commands.hpp"
#include "description.hpp"
#include "durero/io/exported_files.hpp"
#include "durero/io/file_name.hpp"
#include "durero/io/formats.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/pictures/picture_file.hpp"
#include "durero/io/pov/algebraic.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/shown.hpp"
#include "losses.hpp"
#include "progress.hpp"
#include "survey.hpp"

namespace durero::cli {
namespace {

struct ConvertOptions {
  std::string from, to;
  std::string root;       // of the files that `from` may name; empty: its own folder
  std::string with;       // a Z text that says what elements are; empty: none
  std::string triangles;  // how they come in: `mesh`, `single`, or empty: as the format has them
  bool quiet = false, binary = false, survey = false;
};

io::Imported read_any(const ConvertOptions& options) {
  return io::import_file(options.from, {.root = options.root, .keeps_surfaces = !options.with.empty()},
                         options.triangles.empty() ? std::nullopt : std::optional(options.triangles == "mesh"));
}

io::Imported read_scene_file(const ConvertOptions& options) {
  scene::GroupedScene read = io::read_grouped_scene(io::read_source(options.from), io::Bodies::read);
  return {std::move(read.scene), {}, std::move(read.groups)};
}

/// Checks that a format has the name of the file that is to be written, before it is made.
void require_format(const ConvertOptions& options) {
  options.binary ? io::format_to_write_bytes(options.to) : io::format_to_write(options.to);
}

io::Exported write_any(const ConvertOptions& options, const io::Imported& read) {
  return io::exported_scene(options.to, read.scene, read.groups, options.binary);
}

io::Exported write_scene_file(const ConvertOptions& options, const io::Imported& read) {
  if (!options.with.empty()) require_surfaces(options.from, options.with, read.surfaces);
  return {io::scene_text(read.scene, read.groups, {io::algebraic_types(), &read.surfaces}), {}};
}

/// Reads a scene, and writes it to the other file.
int convert(const ConvertOptions& options, io::Imported (*read)(const ConvertOptions&),
            io::Exported (*write)(const ConvertOptions&, const io::Imported&), const std::string& work) {
  io::ExportedFiles out(options.to, options.from);
  std::optional<Progress> progress(std::in_place, options.quiet, work);
  io::Imported scene = read(options);
  io::rename_pictures(scene.scene.stage(), options.from, options.to);
  const io::Exported exported = write(options, scene);
  out.write(exported);
  progress.reset();
  name_losses(options.from, scene.lost);
  name_losses(options.to, exported.lost);
  return 0;
}

int import_scene(const ConvertOptions& options) {
  io::format_to_read(options.from);  // its name is asked before the other file is made
  io::require_ending(options.to, io::json_endings, "a scene");
  return convert(options, read_any, write_scene_file, "import");
}

/// @{ The options that several of the commands have.
void add_ways_to_read(CLI::App& command, ConvertOptions& options) {
  command
      .add_option("--triangles", options.triangles,
                  "How triangles come in: gathered into a mesh, whose points stand once, or single, each an element "
                  "that can be edited alone; without it as the format has them")
      ->check(one_of("way", {"mesh", "single"}));
  command.add_option("--root", options.root,
                     "Folder that holds the files which the text may name; without it the text's own folder");
}
void add_binary(CLI::App& command, bool& binary) {
  command.add_flag("--binary", binary,
                   "Write bytes and not a text: a .ply of binary64, without rounding, or a .stl or .glb of binary32");
}
/// @}

}  // namespace

void add_import(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("import", fmt::format("Read a scene in any format ({})", io::endings_to_read()));
  const auto options = std::make_shared<ConvertOptions>();
  command->add_option("FILE", options->from, "File to read; its name tells the format")->required();
  auto* const output = command->add_option("-o,--output", options->to, "Scene file (JSON) to write, NAME.json");
  output->required();
  add_ways_to_read(*command, *options);
  command->add_option(
      "--with", options->with,
      "Z text that declares algebraic surfaces, such as demo/surfaces/algebraic.tex: those of POV-Ray are "
      "kept, and the scene is one of that text");
  command
      ->add_flag_callback(
          "--survey",
          [options, output] {
            options->survey = true;
            output->required(false);
          },
          "FILE is a folder: write nothing, and tell how many of the files below it are read, what stops the rest, and "
          "what is left out")
      ->excludes(output);
  add_quiet(*command, options->quiet);
  command->footer(
      exit_status("it is written, what is left out is named on the standard error; or all of a folder are read",
                  "some of a folder are not", "the call or the file is bad") +
      examples({"import still-life.nff -o imported.json", "import bunny.obj -o bunny.json --triangles single",
                "import rooms/red/scene.xml -o red.json --root rooms",
                "import rings.pov -o rings.json --with demo/surfaces/algebraic.tex", "import scenes --survey"}));
  command->callback([options, &status] {
    status = options->survey ? survey(options->from, options->root, options->quiet) : import_scene(*options);
  });
}

void add_export(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("export", fmt::format("Write a scene in any format ({})", io::endings_to_write()));
  const auto options = std::make_shared<ConvertOptions>();
  command->add_option("SCENE", options->from, "Scene file (JSON)")->required();
  command->add_option("-o,--output", options->to, "File to write; its name tells the format")->required();
  add_binary(*command, options->binary);
  add_quiet(*command, options->quiet);
  command->footer(
      exit_status("it is written; what is left out is named on the standard error", "the call or the scene is bad") +
      examples({"export demo/still-life.json -o still-life.nff", "export bunny.json -o bunny.ply --binary"}));
  command->callback([options, &status] {
    require_format(*options);
    status = convert(*options, read_scene_file, write_any, "export");
  });
}

void add_convert(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("convert", "Read a scene in one format and write it in another");
  const auto options = std::make_shared<ConvertOptions>();
  command
      ->add_option("FROM", options->from,
                   fmt::format("File to read; its name tells the format ({})", io::endings_to_read()))
      ->required();
  command
      ->add_option("TO", options->to,
                   fmt::format("File to write; its name tells the format ({})", io::endings_to_write()))
      ->required();
  add_ways_to_read(*command, *options);
  add_binary(*command, options->binary);
  add_quiet(*command, options->quiet);
  command->footer(
      exit_status("it is written; what is left out is named on the standard error", "the call or the file is bad") +
      examples({"convert demo/still-life.json still-life.pov", "convert still-life.pov still-life.nff",
                "convert bunny.obj bunny.ply --binary"}));
  command->callback([options, &status] {
    io::format_to_read(options->from);  // its name is asked before the other file is made
    require_format(*options);
    status = convert(*options, read_any, write_any, "convert");
  });
}

}  // namespace durero::cli
