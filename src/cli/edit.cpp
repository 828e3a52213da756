// durero edit SCENE [--script FILE] [--op TEXT]… [-o OUT] [--audit] [--by-spec | --with TEXT]: runs operations, answers
// each in one JSON line. With --why-not OP: runs none, and tells every clause that refuses it.
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
#include "durero/io/json/file_patch.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/operations_file.hpp"
#include "durero/io/json/why_not.hpp"
#include "durero/io/lines.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/pictures/picture_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/scene/stage.hpp"
#include "edit_interactive.hpp"
#include "edit_patch.hpp"
#include "for_each.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

struct EditOptions {
  std::string scene, script, out, with, for_each, json_patch;
  std::vector<std::string> operations, why_not;
  bool audit = false, by_spec = false, all_or_nothing = false, dry_run = false, interactive = false, quiet = false;
};

/// A step of the script, and the element that it is repeated for, if it is.
struct NamedStep {
  io::ScriptStep step;
  std::string for_each{};
};

/// Reads operations, one a line, that follow so many lines of a script.
void append_steps(std::vector<NamedStep>& steps, const io::Source& text, const io::EditedScene& edited,
                  std::size_t lines_before) {
  for (io::ScriptStep& step : io::read_script(text, edited.of().scene.stage(), edited.types())) {
    step.line += lines_before;
    steps.push_back({std::move(step)});
  }
}

io::Source joined(const char* option, const std::vector<std::string>& operations) {
  std::string text;
  for (const std::string& operation : operations) text.append(operation).append("\n");
  return {option, std::move(text)};
}

/// The operations of --op for each element of the set, all of the scene as it is before the first.
std::vector<NamedStep> read_repeated(const EditOptions& options, const io::EditedScene& edited) {
  const scene::Scene& scene = edited.of().scene;
  std::vector<NamedStep> steps;
  for (const auto& [element, text] : repeated(options.operations, scene, elements_of_set(scene, options.for_each))) {
    const std::size_t before = steps.size();
    append_steps(steps, io::Source("--op", text), edited, before);
    for (std::size_t i = before; i < steps.size(); ++i) steps[i].for_each = element;
  }
  return steps;
}

/// The script, where there is one: operations, or a JSON Patch of the scene's file.
struct Script {
  std::optional<io::Source> text{};
  bool is_patch = false;
};

Script read_script_text(const EditOptions& options) {
  if (options.script.empty() && !options.operations.empty()) return {};
  Script script{io::read_lines(options.script.empty() ? "-" : options.script)};
  script.is_patch = io::json::is_patch(*script.text);
  return script;
}

// The script's operations, then those of --op, numbered as lines after the script's last.
std::vector<NamedStep> read_steps(const EditOptions& options, const io::EditedScene& edited, const Script& script) {
  if (!options.for_each.empty()) return read_repeated(options, edited);
  std::vector<NamedStep> steps;
  if (script.text && !script.is_patch) append_steps(steps, *script.text, edited, 0);
  append_steps(steps, joined("--op", options.operations), edited,
               script.text ? io::count_lines(script.text->text()) : 0);
  return steps;
}

/// The text of the scene. A patch is carried out before there is a scene: the answers get a line for each of its
/// operations.
io::Source scene_source(const EditOptions& options, const Script& script, std::string& answers) {
  io::Source source = io::read_source(options.scene);
  if (!script.is_patch) return source;
  io::json::PatchedFile patched = io::json::patched_file(source, *script.text);
  for (const std::size_t operation : patched.operations)
    answers.append(io::answer_text(script.text->place(operation).line, {"patched"})).append("\n");
  io::Source scene(source.name() + " as patched", std::move(patched.text));
  scene.set_root(source.root());
  return scene;
}

std::unique_ptr<io::EditedScene> read(const EditOptions& options, const io::Source& source) {
  if (options.with.empty()) return std::make_unique<io::EditedScene>(io::read_grouped_scene(source, io::Bodies::read));
  return edited_by_text(source, options.with);
}

Editor editor_of(const EditOptions& options) {
  return options.by_spec ? editor_by_spec()
                         : [](io::EditedScene& of, const io::ScriptStep& step) { return of.apply_total(step); };
}

ClauseFinder finder_of(const EditOptions& options) {
  return options.by_spec ? clauses_by_spec() : ClauseFinder(io::why_not);
}

/// Begins a session on the scene.
int begin_session(const EditOptions& options) {
  if (!options.out.empty()) io::require_ending(options.out, io::json_endings, "a scene");
  io::Source source = io::read_source(options.scene);
  std::unique_ptr<io::EditedScene> scene = read(options, source);
  return edit_interactively(
      {std::move(source), std::move(scene), options.with, options.out, editor_of(options), finder_of(options)});
}

/// Tells of each operation every clause that does not hold; nothing is carried out.
int tell_why_not(const EditOptions& options) {
  const std::unique_ptr<io::EditedScene> edited = read(options, io::read_source(options.scene));
  std::vector<NamedStep> steps;
  append_steps(steps, joined("--why-not", options.why_not), *edited, 0);
  const ClauseFinder find = finder_of(options);
  std::string told;
  bool all_hold = true;
  for (const NamedStep& named : steps) {
    const io::WhyNot found = find(*edited, named.step);
    told.append(io::why_not_text(named.step.line, found)).append("\n");
    all_hold = all_hold && found.answer.ok();
  }
  io::print(told);
  return all_hold ? 0 : 1;
}

/// The answers to a script, a line each.
struct Answers {
  std::string text{};
  bool all_done = true;
};

/// Carries out the steps; where all or nothing is to be done, up to the first that is refused.
void carry_out(const EditOptions& options, io::EditedScene& edited, const std::vector<NamedStep>& steps,
               Answers& answers) {
  const Editor apply = editor_of(options);
  Progress progress(options.quiet, "edit", "operations", steps.size());
  for (const auto& [step, for_each] : steps) {
    const io::EditAnswer answer = apply(edited, step);
    answers.text.append(io::answer_text(step.line, answer, for_each)).append("\n");
    answers.all_done = answers.all_done && answer.ok();
    if (!answer.ok() && options.all_or_nothing) break;
    progress.add();
  }
}

int edit(EditOptions options) {
  if (options.audit) contract::set_semantic(contract::cost::audit, contract::evaluation_semantic::enforce);
  if (options.interactive) return begin_session(options);
  if (!options.why_not.empty()) return tell_why_not(options);
  options.all_or_nothing = options.all_or_nothing || !options.for_each.empty();
  if (!options.out.empty()) io::require_ending(options.out, io::json_endings, "a scene");
  const bool writes = !options.out.empty() && !options.dry_run;
  std::optional<io::FileLock> lock;  // until the edited scene is in place
  if (writes && io::is_same_file(options.scene, options.out)) lock.emplace(options.out);
  std::optional<io::OutputFile> out;
  if (writes) out.emplace(options.out);
  const Script script = read_script_text(options);
  Answers answers;
  const std::unique_ptr<io::EditedScene> edited = read(options, scene_source(options, script, answers.text));
  carry_out(options, *edited, read_steps(options, *edited, script), answers);
  if (out && (answers.all_done || !options.all_or_nothing)) {
    io::rename_pictures(edited->stage(), options.scene, options.out);
    out->write(edited->scene_text());
    out->commit();
  }
  io::print(answers.text);
  return answers.all_done ? 0 : 1;
}

}  // namespace

void add_edit(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("edit", "Run operations on a scene, each checked; one JSON line each");
  const auto options = std::make_shared<EditOptions>();
  command->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
  auto* const script = command->add_option("--script", options->script,
                                           "File of operations, one a line, or a JSON Patch; - is the standard input");
  auto* const op =
      command->add_option("--op", options->operations, "An operation; may be given again")->allow_extra_args(false);
  auto* const output = command->add_option("-o,--output", options->out,
                                           "Where the edited scene goes, NAME.json; without it nothing is written");
  auto* const all_or_nothing = command->add_flag("--all-or-nothing", options->all_or_nothing,
                                                 "End at the first operation that is refused, and write nothing then");
  auto* const dry_run = command->add_flag("--dry-run", options->dry_run, "Do everything but write FILE");
  auto* const for_each = command
                             ->add_option("--for-each", options->for_each,
                                          "A set of Z: carry out each --op for each of its elements, all or nothing")
                             ->needs(op)
                             ->excludes(script);
  auto* const why_not =
      command
          ->add_option("--why-not", options->why_not,
                       "Tell every clause of an operation that does not hold, and carry out none; may be given again")
          ->allow_extra_args(false)
          ->excludes(op)
          ->excludes(script)
          ->excludes(output)
          ->excludes(for_each);
  command->add_flag("-i,--interactive", options->interactive, "Read operations line by line, and answer each")
      ->excludes(op)
      ->excludes(script)
      ->excludes(why_not)
      ->excludes(all_or_nothing)
      ->excludes(dry_run);
  command->add_flag("--audit", options->audit, "Check whole predicates, with a copy of the old state");
  auto* const by_spec =
      command->add_flag("--by-spec", options->by_spec, "Let the Z text decide each step too; a difference is a defect");
  command->add_option("--with", options->with, "A Z text that says what the elements are: each is puntos_TIPO")
      ->excludes(by_spec)
      ->excludes(for_each);
  auto* const patch = command->add_option("--json-patch", options->json_patch,
                                          "Carry out a JSON Patch (RFC 6902) of the canonical text, all of it or none");
  for (const char* other :
       {"--script", "--op", "--by-spec", "--with", "--why-not", "--for-each", "--all-or-nothing", "--dry-run"})
    patch->excludes(command->get_option(other));
  add_quiet(*command, options->quiet);
  command->footer(
      "Without --script and --op, operations are read from the standard input. With --with, the types that the text\n"
      "declares have operations too: puntos_toro gives Agregar_Toro and Eliminar_Toro; what the text gives\n"
      "no points is refused with the predicate that does not hold.\n\n"
      "--for-each takes an expression of the text of spec/ over the scene, such as dom mi_radio. In each --op {} "
      "stands\n"
      "for the name of the element, and {radio}, or another attribute's word, for its value in SCENE.\n\n"
      "--why-not prints a line for each operation: every clause that does not hold, with the values of what it names.\n"
      "With --with it tells the first predicate of the text alone, and then says \"whole\":false.\n\n"
      "-i edits line by line: Tab completes operations, inputs and names, undo takes an operation back, write writes\n"
      "the scene, and help tells the rest. A pipe is read as well.\n\n"
      "Where FILE is SCENE itself, others that edit it so wait for each other, and no edit is lost.\n\n"
      "An operation takes no longer in a large scene than in a small one; one on a mesh takes as long as the mesh is\n"
      "large. With --audit or --by-spec each looks at every element, before and after, so that time grows with the\n"
      "operations times the elements.\n\n" +
      exit_status("every operation was carried out", "one was refused, or would be",
                  "the call or a file is bad, and nothing is written") +
      examples({"edit demo/still-life.json --op \"Agregar_Esfera e?=moon centro?=(0,3,4) radio?=0.5\" -o "
                "edited.json",
                "edit demo/still-life.json --why-not \"Agregar_Esfera e?=moon centro?=(0,3,4) radio?=-1\"",
                "edit demo/still-life.json --for-each \"{ e : dom mi_radio | mi_radio e < 1 }\" --op "
                "\"Eliminar_Elemento e?={}\" "
                "-o edited.json",
                "edit demo/surfaces/torus.json --with demo/surfaces/torus.tex --op \"Agregar_Toro e?=small "
                "centro?=(0,2,0) mayor?=1 menor?=0.25\" -o edited.json"}));
  command->callback([options, &status] {
    status =
        options->json_patch.empty() ? edit(*options) : edit_by_patch(options->scene, options->json_patch, options->out);
  });
}

}  // namespace durero::cli
