// durero edit SCENE [--script FILE] [--op TEXT]… [-o OUT] [--audit] [--by-spec | --with TEXT]: runs operations, answers
// each in one JSON line.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "by_text.hpp"
#include "commands.hpp"
#include "description.hpp"
#include "durero/contract/contract.hpp"
#include "durero/io/file_lock.hpp"
#include "durero/io/file_name.hpp"
#include "durero/io/json/edited_scene.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/operations_file.hpp"
#include "durero/io/lines.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/pictures/picture_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/scene/stage.hpp"
#include "edit_patch.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

struct EditOptions {
  std::string scene, script, out, with, json_patch;
  std::vector<std::string> operations;
  bool audit = false, by_spec = false, quiet = false;
};

// The script's operations, then those of --op, numbered as lines after the script's last.
std::vector<io::ScriptStep> read_script(const EditOptions& options, const io::EditedScene& edited) {
  const scene::Stage& stage = edited.of().scene.stage();
  std::vector<io::ScriptStep> steps;
  std::size_t lines = 0;
  if (!options.script.empty() || options.operations.empty()) {
    const io::Source script = io::read_lines(options.script.empty() ? "-" : options.script);
    steps = io::read_script(script, stage, edited.types());
    lines = io::count_lines(script.text());
  }
  std::string joined;
  for (const std::string& operation : options.operations) joined.append(operation).append("\n");
  for (io::ScriptStep& step : io::read_script(io::Source("--op", joined), stage, edited.types())) {
    step.line += lines;
    steps.push_back(std::move(step));
  }
  return steps;
}

std::unique_ptr<io::EditedScene> read(const EditOptions& options) {
  const io::Source source = io::read_source(options.scene);
  if (options.with.empty()) return std::make_unique<io::EditedScene>(io::read_grouped_scene(source, io::Bodies::read));
  return edited_by_text(source, options.with);
}

int edit(const EditOptions& options) {
  if (options.audit) contract::set_semantic(contract::cost::audit, contract::evaluation_semantic::enforce);
  std::optional<io::FileLock> lock;  // until the edited scene is in place
  if (io::is_same_file(options.scene, options.out)) lock.emplace(options.out);
  std::optional<io::OutputFile> out;
  if (!options.out.empty()) {
    io::require_ending(options.out, io::json_endings, "a scene");
    out.emplace(options.out);
  }
  const std::unique_ptr<io::EditedScene> edited = read(options);
  const std::vector<io::ScriptStep> script = read_script(options, *edited);
  const Editor carry_out = options.by_spec ? editor_by_spec() : [](io::EditedScene& of, const io::ScriptStep& step) {
    return of.apply_total(step);
  };
  int status = 0;
  std::string answers;
  Progress progress(options.quiet, "edit", "operations", script.size());
  for (const io::ScriptStep& step : script) {
    const io::EditAnswer answer = carry_out(*edited, step);
    answers.append(io::answer_text(step.line, answer)).append("\n");
    if (!answer.ok()) status = 1;
    progress.add();
  }
  if (out) {
    io::rename_pictures(edited->stage(), options.scene, options.out);
    out->write(edited->scene_text());
    out->commit();
  }
  io::print(answers);
  return status;
}

}  // namespace

void add_edit(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("edit", "Run operations on a scene, each checked; one JSON line each");
  const auto options = std::make_shared<EditOptions>();
  command->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
  command->add_option("--script", options->script, "File of operations, one a line; - is the standard input");
  command->add_option("--op", options->operations, "An operation; may be given again")->allow_extra_args(false);
  command->add_option("-o,--output", options->out,
                      "Where the edited scene goes, NAME.json; without it nothing is written");
  command->add_flag("--audit", options->audit, "Check whole predicates, with a copy of the old state");
  auto* const by_spec =
      command->add_flag("--by-spec", options->by_spec, "Let the Z text decide each step too; a difference is a defect");
  command->add_option("--with", options->with, "A Z text that says what the elements are: each is puntos_TIPO")
      ->excludes(by_spec);
  auto* const patch = command->add_option("--json-patch", options->json_patch,
                                          "Carry out a JSON Patch (RFC 6902) of the canonical text, all of it or none");
  for (const char* other : {"--script", "--op", "--by-spec", "--with"}) patch->excludes(command->get_option(other));
  add_quiet(*command, options->quiet);
  command->footer(
      "Without --script and --op, operations are read from the standard input. With --with, the types that the text\n"
      "declares have operations too: puntos_toro gives Agregar_Toro and Eliminar_Toro; what the text gives\n"
      "no points is refused with the predicate that does not hold.\n\n"
      "Where FILE is SCENE itself, others that edit it so wait for each other, and no edit is lost.\n\n"
      "An operation takes no longer in a large scene than in a small one; one on a mesh takes as long as the mesh is\n"
      "large. With --audit or --by-spec each looks at every element, before and after, so that time grows with the\n"
      "operations times the elements.\n\n" +
      exit_status("every operation was carried out", "one was refused",
                  "the call or a file is bad, and nothing is written") +
      examples({"edit demo/still-life.json --op \"Agregar_Esfera e?=moon centro?=(0,3,4) radio?=0.5\" -o "
                "edited.json",
                "edit demo/surfaces/torus.json --with demo/surfaces/torus.tex --op \"Agregar_Toro e?=small "
                "centro?=(0,2,0) mayor?=1 menor?=0.25\" -o edited.json"}));
  command->callback([options, &status] {
    status =
        options->json_patch.empty() ? edit(*options) : edit_by_patch(options->scene, options->json_patch, options->out);
  });
}

}  // namespace durero::cli
