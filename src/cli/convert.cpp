// durero import FILE -o SCENE, durero export SCENE -o FILE: other scene formats, by file name.
#include <fmt/format.h>

#include "commands.hpp"
#include "durero/io/formats.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/scene_file.hpp"
#include "durero/text/shown.hpp"

namespace durero::cli {
namespace {

struct Options {
  std::string from, to;
};

void name_losses(const std::string& path, const std::vector<std::string>& lost) {
  for (const std::string& line : lost) fmt::print(stderr, "durero: {}: {}\n", text::escaped(path), line);
}

int import_scene(const Options& options) {
  const io::Imported imported = io::format_to_read(options.from).read(io::read_source(options.from));
  io::write_file(options.to, io::scene_text(imported.scene));
  name_losses(options.from, imported.lost);
  return 0;
}

int export_scene(const Options& options) {
  const io::Format& format = io::format_to_write(options.to);
  const io::Exported exported = format.write(io::read_scene(io::read_source(options.from)));
  io::write_file(options.to, exported.text);
  name_losses(options.to, exported.lost);
  return 0;
}

}  // namespace

void add_import(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("import", fmt::format("Read a scene in any format ({})", io::endings_to_read()));
  const auto options = std::make_shared<Options>();
  command->add_option("FILE", options->from, "File to read; its name tells the format")->required();
  command->add_option("-o,--output", options->to, "Scene file (JSON) to write")->required();
  command->callback([options, &status] { status = import_scene(*options); });
}

void add_export(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("export", fmt::format("Write a scene in any format ({})", io::endings_to_write()));
  const auto options = std::make_shared<Options>();
  command->add_option("SCENE", options->from, "Scene file (JSON)")->required();
  command->add_option("-o,--output", options->to, "File to write; its name tells the format")->required();
  command->callback([options, &status] { status = export_scene(*options); });
}

}  // namespace durero::cli
