// durero check SCENE [--format F] [--with TEXT]: reads a scene, and evaluates every invariant of Escena on what it
// stands for. durero check SCENE --fix: proposes a script that may mend it. durero check --mesh FILE [--point X,Y,Z]:
// audits the triangles of a file as one mesh.
#include <unistd.h>

#include <memory>
#include <optional>
#include <string>

#include "by_text.hpp"
#include "colour.hpp"
#include "commands.hpp"
#include "description.hpp"
#include "durero/io/json/scene_check.hpp"
#include "durero/io/json/scene_fixes.hpp"
#include "durero/io/standard_output.hpp"
#include "mesh_audit.hpp"
#include "numbers.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

struct CheckOptions : AuditCall {
  std::string with;
  bool mesh = false, fix = false;
};

/// Checks the scene; by a Z text where one is named.
io::SceneCheck checked(const CheckOptions& options) {
  const io::Source source = io::read_source(options.scene);
  return options.with.empty() ? io::check_scene(source) : check_by_text(source, options.with);
}

/// Prints the script that may mend the scene. The first thing that it does not mend is the error.
int propose(const CheckOptions& options) {
  std::optional<Progress> progress(std::in_place, options.quiet, "check");
  const io::SceneFixes fixes = io::scene_fixes(io::read_source(options.scene));
  progress.reset();
  io::print(fixes.script);
  if (fixes.left) throw io::InputError(*fixes.left);
  return fixes.script.empty() ? 0 : 1;
}

/// Runs the check. A file with an error is refused whatever the format. For programs, all its faults are printed
/// before.
int run(const CheckOptions& options) {
  if (options.mesh) return audit_mesh(options);
  if (options.fix) return propose(options);
  std::optional<Progress> progress(std::in_place, options.quiet, "check");
  const io::SceneCheck check = checked(options);
  progress.reset();
  if (options.format == "json") io::print(check_json(check));
  if (options.format == "sarif") io::print(check_sarif(check));
  if (!check.errors.empty()) throw io::InputError(check.errors.front());
  if (options.format == "text") io::print(check_text(check, in_red("fails", STDOUT_FILENO)));
  return check.findings.empty() ? 0 : 1;
}

}  // namespace

void add_check(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("check", "Read a scene and evaluate every invariant, or audit a mesh");
  const auto options = std::make_shared<CheckOptions>();
  command->add_option("SCENE", options->scene, "Scene file (JSON); - is the standard input")->required();
  auto* const format =
      command->add_option("--format", options->format, "How the answer is printed; sarif is SARIF 2.1.0")
          ->check(one_of("format", {"text", "json", "sarif"}))
          ->capture_default_str();
  auto* const with =
      command->add_option("--with", options->with, "A Z text that says what the elements are: each is puntos_TIPO");
  auto* const mesh =
      command
          ->add_flag("--mesh", options->mesh,
                     "Audit the triangles of a scene, or of a glTF, an OBJ, a PLY or an STL file, as one mesh")
          ->excludes(with);
  command->add_option("--point", options->point, "With --mesh: a point, X,Y,Z, of which the side is told")
      ->needs(mesh)
      ->check(CLI::Validator(check_point, ""));
  command
      ->add_option("--picture", options->picture,
                   "With --mesh: a picture of the mesh from two sides, with the findings marked, NAME.png")
      ->needs(mesh);
  command
      ->add_option("--most", options->most,
                   "With --mesh: list no more findings of each kind, and no more pieces; the others are counted")
      ->needs(mesh)
      ->check(whole_number(1, 1'000'000'000));
  command
      ->add_flag("--fix", options->fix,
                 "Print a script for edit --script that may mend the scene; nothing is mended here")
      ->excludes(mesh)
      ->excludes(with)
      ->excludes(format);
  add_quiet(*command, options->quiet);
  command->footer(
      "--fix proposes operations that drop what is the same as another element, or, where the file holds no scene, a\n"
      "JSON Patch: an axis at unit length, one name for each element, no triangle on one line, each member in one "
      "group.\n"
      "What nothing is proposed for is the error.\n\n"
      "As JSON and SARIF all that is wrong with the file is printed, each with its label, its JSON pointer and its\n"
      "place; the first is the error on stderr. --with asks the text besides what the points of each element are.\n\n" +
      exit_status("every invariant holds, the mesh has no fault, or nothing is to be mended", "otherwise",
                  "the call or the file is bad") +
      examples({"check demo/still-life.json", "check demo/still-life.json --fix",
                "check demo/still-life.json --format json", "check --mesh bunny.ply",
                "check --mesh bunny.ply --point 0,0.1,0", "check --mesh bunny.ply --picture findings.png"}));
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace durero::cli
