// durero diff A B [--json-patch | --json | --summary]: the operations that make one scene of another. durero diff --git
// and durero diff --text FILE: for git, as its drivers ask.
#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "commands.hpp"
#include "description.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_changes.hpp"
#include "durero/io/json/scene_patch.hpp"
#include "durero/io/json/scene_script.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/shown.hpp"
#include "git_scene.hpp"

namespace durero::cli {
namespace {

struct DiffOptions {
  std::vector<std::string> files;
  bool json_patch = false, json = false, summary = false, git = false, text = false;
};

std::string lines_of(const std::vector<io::PartChange>& changes) {
  std::string lines;
  for (const io::PartChange& change : changes) lines.append(io::change_text(change)).append("\n");
  return lines;
}

/// The script; refuses what no operation says.
std::string script_or_error(const std::string& file, const scene::GroupedScene& from, const scene::GroupedScene& to) {
  const io::SceneScript script = io::script_between(from, to);
  if (!script.beyond.empty()) {
    throw io::FileError(file, fmt::format("no operation makes {} so", script.beyond.front()),
                        "expected --json-patch, --json or --summary, which say every difference");
  }
  return io::script_text(script, from.scene.stage());
}

void require_files(const DiffOptions& options, std::size_t least, std::size_t most, const char* expected) {
  if (options.files.size() < least || options.files.size() > most)
    throw std::invalid_argument(fmt::format("diff: {} arguments; expected {}", options.files.size(), expected));
}

/// The answer in the way that was chosen; empty where the scenes are the same, but for a patch.
std::string difference_text(const DiffOptions& options, const scene::GroupedScene& from,
                            const scene::GroupedScene& to) {
  if (options.json_patch) return io::scene_patch(from, to);
  if (options.json) return lines_of(io::part_changes(from, to));
  if (options.summary) return io::changes_summary(io::part_changes(from, to));
  return script_or_error(options.files[1], from, to);
}

int diff(const DiffOptions& options) {
  require_files(options, 2, 2, "two scenes");
  const scene::GroupedScene from = io::read_grouped_scene(io::read_source(options.files[0]), io::Bodies::read);
  const scene::GroupedScene to = io::read_grouped_scene(io::read_source(options.files[1]), io::Bodies::read);
  const std::string text = difference_text(options, from, to);
  io::print(text);
  return text.empty() || text == io::empty_patch ? 0 : 1;
}

/// What git asks of a driver: PATH OLD HASH MODE NEW HASH MODE, and of a renamed file two words more; status 0. Of a
/// difference that no operation makes it prints the parts.
int diff_for_git(const DiffOptions& options) {
  require_files(options, 7, 9, "what git passes: PATH OLD HASH MODE NEW HASH MODE");
  const scene::GroupedScene from = git_scene(options.files[1]), to = git_scene(options.files[4]);
  const io::SceneScript script = io::script_between(from, to);
  const std::string path = text::escaped(options.files[0]);
  io::print(fmt::format("diff --durero a/{} b/{}\n", path, path) + (script.beyond.empty()
                                                                        ? io::script_text(script, from.scene.stage())
                                                                        : lines_of(io::part_changes(from, to))));
  return 0;
}

int print_text(const DiffOptions& options) {
  require_files(options, 1, 1, "one scene");
  const scene::GroupedScene of = git_scene(options.files[0]);
  io::print(io::scene_text(of.scene, of.groups));
  return 0;
}

int run_diff(const DiffOptions& options) {
  if (options.git) return diff_for_git(options);
  return options.text ? print_text(options) : diff(options);
}

}  // namespace

void add_diff(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("diff", "Print the operations that make one scene of another");
  const auto options = std::make_shared<DiffOptions>();
  command->add_option("SCENE", options->files, "Two scene files (JSON), the one before and the one after")->required();
  std::vector<CLI::Option*> ways;
  const auto add_way = [&](const char* name, bool& is_chosen, const char* description) {
    CLI::Option* const way = command->add_flag(name, is_chosen, description);
    for (CLI::Option* other : ways) way->excludes(other);
    ways.push_back(way);
  };
  add_way("--json-patch", options->json_patch,
          "Print a JSON Patch (RFC 6902) of the canonical text, for edit --json-patch");
  add_way("--json", options->json, "Print each part that differs in one JSON line, with both its values");
  add_way("--summary", options->summary, "Print how many parts of each kind were added, removed and changed");
  add_way("--git", options->git, "For git's diff.NAME.command: take its seven words, and end with status 0");
  add_way("--text", options->text, "For git's diff.NAME.textconv: print the canonical text of one scene");
  command->footer(
      "The script makes the second scene of the first, byte for byte: durero edit A --script SCRIPT -o B. An element\n"
      "that is the same in both stands in no line.\n\n" +
      exit_status("the scenes are the same", "they differ",
                  "the call or a file is bad, or no operation makes a difference") +
      examples({"diff before.json after.json", "diff before.json after.json --json-patch",
                "diff before.json after.json --summary"}));
  command->callback([options, &status] { status = run_diff(*options); });
}

}  // namespace durero::cli
