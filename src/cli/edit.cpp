// durero edit SCENE [--script FILE] [--op TEXT]… [-o OUT] [--audit]: runs operations, answers each in one JSON line.
#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <variant>

#include "commands.hpp"
#include "description.hpp"
#include "durero/contract/contract.hpp"
#include "durero/io/groups_file.hpp"
#include "durero/io/lines.hpp"
#include "durero/io/operations_file.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/picture_file.hpp"
#include "durero/io/scene_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/oracle/spec.hpp"
#include "durero/scene/retrieve.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

struct EditOptions {
  std::string scene, script, out;
  std::vector<std::string> operations;
  bool audit = false, by_spec = false, quiet = false;
};

// The script's operations, then those of --op, numbered as lines after the script's last.
std::vector<io::Step> read_script(const EditOptions& options, const scene::Stage& stage) {
  std::vector<io::Step> steps;
  std::size_t lines = 0;
  if (!options.script.empty() || options.operations.empty()) {
    const io::Source script = io::read_source(options.script.empty() ? "-" : options.script);
    steps = io::read_script(script, stage);
    lines = io::count_lines(script.text());
  }
  std::string joined;
  for (const std::string& operation : options.operations) joined.append(operation).append("\n");
  for (io::Step& step : io::read_script(io::Source("--op", joined), stage)) {
    step.line += lines;
    steps.push_back(std::move(step));
  }
  return steps;
}

// The Z text decides the same step. Where it decides otherwise the program is wrong, and writes nothing.
void agree_by_text(const oracle::spec::Judge& judge, const model::Escena& before, std::size_t line,
                   const model::Operation& operation, const model::Answer& answer, const model::Escena& after) {
  const auto difference = judge.difference(before, operation, answer, after);
  if (!difference) return;
  throw std::logic_error(fmt::format("a defect of the program: at line {}, {}; expected that contracts and text agree",
                                     line, *difference));
}

/// What steps are carried out on, and the text as their judge, if it is asked.
struct Edited {
  scene::GroupedScene of;
  std::optional<oracle::spec::Judge> judge = {};

  /// Answers in a line of JSON, and whether it was done.
  struct Done {
    std::string answer;
    bool ok;
  };

  Done carry_out(std::size_t line, const scene::Edit& edit) {
    std::optional<model::Escena> before;
    if (judge) before = scene::retrieve(of.scene);
    const model::Answer answer = of.apply_total(edit);
    if (judge) agree_by_text(*judge, *before, line, edit.operation, answer, scene::retrieve(of.scene));
    return {io::answer_text(line, answer), answer.ok()};
  }

  /// Of groups the text does not speak.
  Done carry_out(std::size_t line, const scene::GroupEdit& edit) {
    const scene::Outcome answer = of.apply_total(edit);
    return {io::answer_text(line, answer), answer.ok()};
  }
};

int edit(const EditOptions& options) {
  if (options.audit) contract::set_semantic(contract::cost::audit, contract::evaluation_semantic::enforce);
  std::optional<io::OutputFile> out;
  if (!options.out.empty()) out.emplace(options.out);
  Edited edited{.of = io::read_grouped_scene(io::read_source(options.scene))};
  const std::vector<io::Step> script = read_script(options, edited.of.scene.stage());
  if (options.by_spec) edited.judge.emplace();
  int status = 0;
  std::string answers;
  Progress progress(options.quiet, "edit", "operations", script.size());
  for (const io::Step& step : script) {
    const Edited::Done done =
        std::visit([&](const auto& edit) { return edited.carry_out(step.line, edit); }, step.edit);
    answers.append(done.answer).append("\n");
    if (!done.ok) status = 1;
    progress.add();
  }
  if (out) {
    io::rename_pictures(edited.of.scene.stage(), options.scene, options.out);
    out->write(io::scene_text(edited.of.scene, edited.of.groups));
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
  command->add_option("-o,--output", options->out, "Where the edited scene goes; without it nothing is written");
  command->add_flag("--audit", options->audit, "Check whole predicates, with a copy of the old state");
  command->add_flag("--by-spec", options->by_spec, "Let the Z text decide each step too; a difference is a defect");
  add_quiet(*command, options->quiet);
  command->footer("Without --script and --op, operations are read from the standard input.\n\n" +
                  exit_status("every operation was carried out", "one was refused",
                              "the call or a file is bad, and nothing is written") +
                  examples({"edit demo/still-life.json --op \"Agregar_Esfera e?=moon centro?=(0,3,4) radio?=0.5\" -o "
                            "edited.json"}));
  command->callback([options, &status] { status = edit(*options); });
}

}  // namespace durero::cli
