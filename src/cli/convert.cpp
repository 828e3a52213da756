// durero import FILE -o SCENE, durero export SCENE -o FILE: other scene formats, by file name. durero import FOLDER
// --survey: which files of a folder can be read.
#include <fmt/format.h>

#include <optional>

#include "commands.hpp"
#include "description.hpp"
#include "durero/io/file_name.hpp"
#include "durero/io/formats.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/mesh/gathered.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/pictures/picture_file.hpp"
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
  std::string triangles;  // how they come in: `mesh`, `single`, or empty: as the format has them
  bool quiet = false, binary = false, survey = false;
};

int import_scene(const ConvertOptions& options) {
  const io::Format& format = io::format_to_read(options.from);  // its name is asked before the other file is made
  io::require_ending(options.to, io::json_endings, "a scene");
  io::OutputFile out(options.to);
  std::optional<Progress> progress(std::in_place, options.quiet, "import");
  io::Imported imported = io::read_any_format(options.from);
  if (options.triangles == "mesh" || (options.triangles.empty() && format.is_mesh))
    imported = io::gathered(std::move(imported), options.from);
  io::rename_pictures(imported.scene.stage(), options.from, options.to);
  out.write(io::scene_text(imported.scene, imported.groups));
  out.commit();
  progress.reset();
  name_losses(options.from, imported.lost);
  return 0;
}

int export_scene(const ConvertOptions& options) {
  const io::Format& format = options.binary ? io::format_to_write_bytes(options.to) : io::format_to_write(options.to);
  io::OutputFile out(options.to);
  std::optional<Progress> progress(std::in_place, options.quiet, "export");
  auto [scene, groups] =
      io::read_grouped_scene(io::read_source(options.from), format.has_bodies ? io::Bodies::read : io::Bodies::refused);
  io::rename_pictures(scene.stage(), options.from, options.to);
  const io::Exported exported = (options.binary ? format.write_bytes : format.write)(scene, groups);
  out.write(exported.text);
  out.commit();
  progress.reset();
  name_losses(options.to, exported.lost);
  return 0;
}

}  // namespace

void add_import(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("import", fmt::format("Read a scene in any format ({})", io::endings_to_read()));
  const auto options = std::make_shared<ConvertOptions>();
  command->add_option("FILE", options->from, "File to read; its name tells the format")->required();
  auto* const output = command->add_option("-o,--output", options->to, "Scene file (JSON) to write, NAME.json");
  output->required();
  command
      ->add_option("--triangles", options->triangles,
                   "How triangles come in: gathered into a mesh, whose points stand once, or single, each an element "
                   "that can be edited alone; without it as the format has them")
      ->check(one_of("way", {"mesh", "single"}));
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
                "import scenes --survey"}));
  command->callback([options, &status] {
    status = options->survey ? survey(options->from, options->quiet) : import_scene(*options);
  });
}

void add_export(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("export", fmt::format("Write a scene in any format ({})", io::endings_to_write()));
  const auto options = std::make_shared<ConvertOptions>();
  command->add_option("SCENE", options->from, "Scene file (JSON)")->required();
  command->add_option("-o,--output", options->to, "File to write; its name tells the format")->required();
  command->add_flag("--binary", options->binary,
                    "Write bytes and not a text: a .ply of binary64, without rounding, or a .stl of binary32");
  add_quiet(*command, options->quiet);
  command->footer(
      exit_status("it is written; what is left out is named on the standard error", "the call or the scene is bad") +
      examples({"export demo/still-life.json -o still-life.nff", "export bunny.json -o bunny.ply --binary"}));
  command->callback([options, &status] { status = export_scene(*options); });
}

}  // namespace durero::cli
