// durero spec …: the Z text read, type-checked, evaluated, shown with all that carries it out, and asked about hits.
#include "spec.hpp"

#include <fmt/format.h>

#include <limits>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "description.hpp"
#include "durero/io/source.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/spec/spec.hpp"
#include "durero/spec/text_check.hpp"
#include "durero/zed/review/review.hpp"
#include "embedded.hpp"
#include "progress.hpp"
#include "spec_cases.hpp"
#include "spec_explore.hpp"
#include "spec_lsp.hpp"
#include "spec_refine.hpp"
#include "spec_run.hpp"

namespace durero::cli {
namespace {

struct SpecOptions {
  CheckCall check;
  EvalCall eval;
  RunCall run;
  std::vector<std::string> files;
  std::string name, scene, rays, hits;
  bool quiet = false;
};

// Reads the files. Throws where one cannot be read.
std::vector<std::pair<std::string, std::string>> sources(const std::vector<std::string>& files) {
  std::vector<std::pair<std::string, std::string>> texts;
  for (const std::string& file : files) texts.emplace_back(file, io::read_source(file).text());
  return texts;
}

/// Keeps the data of a command until the program ends, without the destruction that would take long.
template <class T>
const T& kept(T value) {
  static std::vector<std::unique_ptr<T>>& all = *new std::vector<std::unique_ptr<T>>;
  return *all.emplace_back(std::make_unique<T>(std::move(value)));
}

const zed::Specification& read_texts_of(const std::vector<std::string>& files) {
  return files.empty() ? spec::text() : kept(zed::read_sources(sources(files)));
}

void refuse_error(const std::vector<zed::Defect>& defects) {
  for (const zed::Defect& defect : defects)
    if (defect.severity == zed::Defect::Severity::error)
      throw io::InputError(defect.file, {defect.place.line, defect.place.column}, defect.what, defect.expected);
}

}  // namespace

void refuse_unread(const std::vector<std::string>& files, const zed::Specification& read) {
  refuse_error(read.defects);
  refuse_error(zed::without_paragraphs(files, read));
}

zed::Specification specification_of(const std::vector<std::string>& files) {
  zed::Specification read = read_texts_of(files);
  if (read.defects.empty() && !files.empty()) refuse_error(zed::check(read).defects);
  refuse_unread(files, read);
  return read;
}

/// How the text is checked. Throws io::InputError where the call asks for what the program's own text does not admit.
static spec::TextCheckSetup setup_of(const CheckCall& call) {
  const bool own = call.files.empty();
  spec::TextCheckSetup setup{call.let, call.states, call.strict, own, call.scope};
  if (!call.numbers.empty()) setup.numbers = number_bounds(call.numbers);
  if (own && (!call.scope.empty() || setup.numbers))
    throw io::InputError(call.scope.empty() ? "--numbers" : "--scope", {1, 1},
                         "the program's own text is tried on samples of its own", "expected FILES");
  return setup;
}

int spec_check(const CheckCall& call) {
  spec::TextCheckSetup setup = setup_of(call);
  std::optional<Progress> progress(std::in_place, call.quiet, "spec check");
  const zed::Specification& read = read_texts_of(call.files);
  const zed::Typing& typing = kept(zed::check(read));
  const bool own = setup.own;
  const spec::LabelIndex index(own ? embedded::labels().begin()->second : "");
  std::optional<zed::SmtProgram> solver;
  if (!call.solver.program.empty()) solver = solver_program(call.solver);
  setup.solver = solver ? &*solver : nullptr;
  const spec::TextCheck check =
      with_constants([&] { return spec::check_text(read, typing, call.files, setup, index); });
  note_taken(spec::taken_lines(check.taken));
  progress.reset();
  io::print(check.lines());
  if (const std::size_t untried = check.untried(); untried > 0 && (!own || call.all_tried))
    io::complain(fmt::format("durero: note: {} conjecture{} not tried, as said of each\n", untried,
                             untried == 1 ? " is" : "s are"));
  return check.is_read() && !check.is_refuted() && (!call.all_tried || check.untried() == 0) ? 0 : 1;
}

void note_taken(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) io::complain("durero: note: " + line + "\n");
}

namespace {

void add_let(CLI::App& command, std::vector<std::string>& to) {
  command.add_option("--let", to, "The value of a constant that the text leaves open: NAME=VALUE, in Z")
      ->allow_extra_args(false);
}

void add_run(CLI::App& spec, const std::shared_ptr<SpecOptions>& options, int& status) {
  RunCall& run = options->run;
  auto* command = spec.add_subcommand("run", "Step through the operations of a Z text");
  command->add_option("FILES", run.files, "Z text in LaTeX or Unicode mark-up; without it, the program's own text");
  command->add_option("--state", run.setup.state,
                      "The state schema; without it, that of most components with operations, and of the program's own "
                      "text Escena");
  command->add_option("--init", run.setup.init, "The initial schema; without it, Init, or Init and the state's name");
  command->add_option("--given", run.given, "A given set's members: NAME=3, or NAME=ann,bob");
  add_let(*command, run.setup.constants);
  command->add_option("--members", run.setup.members, "How many members other given sets have")
      ->check(whole_number(1, 20))
      ->capture_default_str();
  command
      ->add_option("--numbers", run.setup.numbers,
                   "Numbers are looked for from -N to N, and from N below to N above the one before")
      ->check(whole_number(0, 1000))
      ->capture_default_str();
  command
      ->add_option("--inputs", run.setup.inputs,
                   "How many choices of inputs, and of what equations leave open, are tried")
      ->check(whole_number(1, 1'000'000))
      ->capture_default_str();
  command->add_option("--choices", run.choices, "How many ways to go on are listed")
      ->check(whole_number(1, 1000))
      ->capture_default_str();
  command->add_option("--states", run.states, "How many states an exploration has at most")
      ->check(whole_number(1, 1'000'000))
      ->capture_default_str();
  command->add_option("--steps", run.setup.steps, "How many steps of evaluation one question may take")
      ->check(whole_number(1, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  command
      ->add_option("--memory", run.memory,
                   "MiB that it may take; without it 4096, or half of the machine's memory where that is less")
      ->check(whole_number(64, 1 << 30));
  command->add_option("--replay", run.replay, "A saved trace to begin with");
  command->footer(
      "A state is a schema S, an operation one that has the components of S and of S ', inputs end in ? and outputs "
      "in\n"
      "!. Commands are read a line each; help lists them. What is looked for is bounded by the options, and what was\n"
      "left out is said with the option that would admit it.\n\n" +
      exit_status("all was done", "a conjecture is false in some state",
                  "the call is bad, a text is wrong, or a command in a pipe cannot be done") +
      examples({"spec run demo/birthday_book.tex", "spec run demo/birthday_book.tex --given NAME=ann,bob"}));
  command->callback([options, &status] { status = spec_run(options->run); });
}

}  // namespace

void add_spec(CLI::App& app, int& status) {
  auto* spec = app.add_subcommand("spec", "Read, check, evaluate and show the Z text");
  spec->require_subcommand(1);
  spec->footer(examples({"spec check", "spec eval '1 + 2 * 3'", "spec show Escena"}));
  add_spec_export(*spec, status);
  add_spec_convert(*spec, status);
  const auto options = std::make_shared<SpecOptions>();

  auto* check = spec->add_subcommand("check", "Read and type-check Z text; each defect at its line");
  check->add_option("FILES", options->check.files,
                    "Z text in LaTeX or Unicode mark-up; without it, the program's own text");
  add_let(*check, options->check.let);
  check
      ->add_option("--scope", options->check.scope,
                   "What conjectures are tried within: a given set's members, SET=3 or SET=ann,bob, or a constant's "
                   "value, as --let")
      ->allow_extra_args(false);
  check->add_option("--numbers", options->check.numbers,
                    "The whole numbers that are tried, LOW..HIGH; without it 0, 1, 2, 3 and -1");
  check->add_flag("--strict", options->check.strict, "Refuse what is only an opinion, too");
  check->add_flag("--all-tried", options->check.all_tried, "Fail where a conjecture is neither decided nor tried");
  check->add_option("--states", options->check.states, "On how many states each conjecture is tried, at most")
      ->check(whole_number(0, 1000000))
      ->capture_default_str();
  add_solver(*check, options->check.solver);
  add_quiet(*check, options->check.quiet);
  check->footer(
      "Opinions are what ISO Z takes and a refinement would remove: an operation that leaves a part of the "
      "after-state\n"
      "open, a function applied where nothing gives its domain, and Δ or Ξ of an operation.\n\n"
      "A conjecture, ⊢? P, is evaluated, and else tried on states: values for what its ∀ declares, small ones first, "
      "the\n"
      "same at every call. To try is not to prove; of the program's own text the theorem that proves it is named.\n\n" +
      exit_status("no error, and no conjecture is false", "an error, or a counterexample, or what --all-tried refuses",
                  "the call is bad, or a file cannot be read") +
      examples({"spec check", "spec check mine.tex", "spec check --strict", "spec check --states 100",
                "spec check demo/birthday_book.tex --scope NAME=2 --scope DATE=2"}));
  check->callback([options, &status] { status = spec_check(options->check); });

  auto* eval = spec->add_subcommand("eval", "The value of an expression, or whether a predicate holds");
  eval->add_option("EXPR", options->eval.expression, "Z, in Unicode or in LaTeX mark-up")->required();
  eval->add_option("FILES", options->eval.files,
                   "Z text in LaTeX or Unicode mark-up; without it, the program's own text");
  eval->add_option("--scene", options->eval.scene, "Scene file: Escena's components and the elements are then names");
  add_let(*eval, options->eval.let);
  eval->add_option(
          "--scope", options->eval.scope,
          "What the answer is for: a given set's members, SET=3 or SET=ann,bob, or a constant's value, as --let")
      ->allow_extra_args(false);
  add_solver(*eval, options->eval.solver);
  eval->add_flag("--explain", options->eval.explain)
      ->excludes("--solver")
      ->description("Print each part of it with its value, and what makes a ∀ false or an ∃ true");
  eval->add_option("--steps", options->eval.steps,
                   "How many steps it may take; as many as by default take about a minute")
      ->check(whole_number(1, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  eval->add_option("--memory", options->eval.memory,
                   "MiB that it may take; without it 4096, or half of the machine's memory where that is less")
      ->check(whole_number(64, 1 << 30));
  eval->footer(
      "θ is a letter, so a space stands behind it: θ Escena.\n"
      "An element's name may stand between quotation marks, and does where it is no word: mi_radio(\"a-b\").\n"
      "Numbers may be decimal; / and √ are known: 0.25 + 1/3 * √2.\n"
      "What begins with - is taken for an option unless -- stands before it: spec eval -- '-(2)'.\n\n" +
      exit_status("a value, or true", "undefined, or false",
                  "it cannot be read, or decided, or takes more steps or memory than it may") +
      examples({"spec eval '1/3 + 0.25'", "spec eval '# elementos' --scene demo/still-life.json",
                "spec eval '# REPORT' demo/birthday_book.tex"}));
  add_quiet(*eval, options->eval.quiet);
  eval->callback([options, &status] { status = spec_eval(options->eval); });

  auto* show = spec->add_subcommand("show", "A paragraph, and where each of its predicates is carried out");
  show->add_option("NAME", options->name, "A name that the text declares, or a label")->required();
  show->add_option("FILES", options->files, "Z text in LaTeX or Unicode mark-up; without it, the program's own text");
  show->footer(exit_status("it is shown", "the call is bad, or the text has no such name") +
               examples({"spec show Escena", "spec show reduccion.def.2"}));
  show->callback([options, &status] { status = spec_show(options->name, options->files); });

  add_run(*spec, options, status);
  add_spec_refine(*spec, status);
  add_spec_explore(*spec, status);
  add_spec_cases(*spec, status);
  add_spec_lsp(*spec, status);

  auto* confirm = spec->add_subcommand("confirm", "Let the Z text decide whether hits are right");
  confirm->footer(
      "The text decides all of it: where on the ray its points lie on an element, and so that a miss is one; the\n"
      "elements of the point; which point is the reduction of them all; and where no point is nearest. The program\n"
      "adds the roots of the polynomials in t that the text compares with 0, and the rounding of the hit's numbers.\n"
      "Each ray has one line in HITS, in any order. A JSON line for each ray and one with the counts go to "
      "stdout.\n\n" +
      exit_status("every ray is answered, and rightly", "some ray is not",
                  "the call is bad, or a file cannot be read") +
      examples({"spec confirm demo/still-life.json demo/rays.txt hits.jsonl"}));
  confirm->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
  confirm->add_option("RAYS", options->rays, "Ray file")->required();
  confirm->add_option("HITS", options->hits, "Hit file (JSON lines)")->required();
  add_quiet(*confirm, options->quiet);
  confirm->callback(
      [options, &status] { status = spec_confirm(options->scene, options->rays, options->hits, options->quiet); });
}

}  // namespace durero::cli
