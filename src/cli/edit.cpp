// durero edit SCENE [--script FILE] [--op TEXT]… [-o OUT] [--audit]: runs operations, answers each in one JSON line.
#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "commands.hpp"
#include "description.hpp"
#include "durero/contract/contract.hpp"
#include "durero/io/lines.hpp"
#include "durero/io/operations_file.hpp"
#include "durero/io/output_file.hpp"
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
std::vector<io::Instruction> read_script(const EditOptions& options, const scene::Stage& stage) {
  std::vector<io::Instruction> instructions;
  std::size_t lines = 0;
  if (!options.script.empty() || options.operations.empty()) {
    const io::Source script = io::read_source(options.script.empty() ? "-" : options.script);
    instructions = io::read_operations(script, stage);
    lines = io::count_lines(script.text());
  }
  std::string joined;
  for (const std::string& operation : options.operations) joined.append(operation).append("\n");
  for (io::Instruction& instruction : io::read_operations(io::Source("--op", joined), stage)) {
    instruction.line += lines;
    instructions.push_back(std::move(instruction));
  }
  return instructions;
}

// The Z text decides the same step. Where it decides otherwise the program is wrong, and writes nothing.
void agree_by_text(const oracle::spec::Judge& judge, const model::Escena& before, const io::Instruction& instruction,
                   const model::Answer& answer, const model::Escena& after) {
  const auto difference = judge.difference(before, instruction.edit.operation, answer, after);
  if (!difference) return;
  throw std::logic_error(fmt::format("a defect of the program: at line {}, {}; expected that contracts and text agree",
                                     instruction.line, *difference));
}

int edit(const EditOptions& options) {
  if (options.audit) contract::set_semantic(contract::cost::audit, contract::evaluation_semantic::enforce);
  std::optional<io::OutputFile> out;
  if (!options.out.empty()) out.emplace(options.out);
  scene::Scene scene = io::read_scene(io::read_source(options.scene));
  const std::vector<io::Instruction> script = read_script(options, scene.stage());
  std::optional<oracle::spec::Judge> judge;
  if (options.by_spec) judge.emplace();
  int status = 0;
  std::string answers;
  Progress progress(options.quiet, "edit", "operations", script.size());
  for (const io::Instruction& instruction : script) {
    std::optional<model::Escena> before;
    if (judge) before = scene::retrieve(scene);
    const model::Answer answer = scene.apply_total(instruction.edit);
    if (judge) agree_by_text(*judge, *before, instruction, answer, scene::retrieve(scene));
    answers.append(io::answer_text(instruction.line, answer)).append("\n");
    if (!answer.ok()) status = 1;
    progress.add();
  }
  if (out) {
    out->write(io::scene_text(scene));
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
