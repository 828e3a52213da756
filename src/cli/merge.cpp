// durero merge BASE OURS THEIRS -o OUT: puts two changes of one scene together, or prints each conflict in a JSON line.
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

#include "commands.hpp"
#include "description.hpp"
#include "durero/io/file_lock.hpp"
#include "durero/io/file_name.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_merge.hpp"
#include "durero/io/output_file.hpp"
#include "durero/io/pictures/picture_file.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/scene/stage.hpp"
#include "git_scene.hpp"

namespace durero::cli {
namespace {

struct MergeOptions {
  std::string base, ours, theirs, out;
};

int merge(const MergeOptions& options) {
  std::optional<io::FileLock> lock;  // until the merged scene is in place
  if (io::is_same_file(options.ours, options.out)) lock.emplace(options.out);
  io::require_ending(options.out, io::json_endings, "a scene");
  io::OutputFile out(options.out);
  const scene::GroupedScene base = git_scene(options.base);
  const scene::GroupedScene ours = io::read_grouped_scene(io::read_source(options.ours), io::Bodies::read);
  const scene::GroupedScene theirs = io::read_grouped_scene(io::read_source(options.theirs), io::Bodies::read);
  io::SceneMerge merge = io::merged_scene(base, ours, theirs);
  if (!merge.scene) {
    std::string conflicts;
    for (const io::MergeConflict& conflict : merge.conflicts)
      conflicts.append(io::conflict_text(conflict)).append("\n");
    io::print(conflicts);
    return 1;
  }
  io::rename_pictures(merge.scene->scene.stage(), options.ours, options.out);
  out.write(io::scene_text(merge.scene->scene, merge.scene->groups));
  out.commit();
  return 0;
}

}  // namespace

void add_merge(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("merge", "Put two changes of one scene together, or name the conflicts");
  const auto options = std::make_shared<MergeOptions>();
  command->add_option("BASE", options->base, "Scene file (JSON) before both changes; an empty file is the empty scene")
      ->required();
  command->add_option("OURS", options->ours, "Scene file (JSON) after one change")->required();
  command->add_option("THEIRS", options->theirs, "Scene file (JSON) after the other change")->required();
  command->add_option("-o,--output", options->out, "Where the merged scene goes, NAME.json")->required();
  command->footer(
      "Scenes are merged part by part: an element, a mesh, a group, a material, a key of the camera. A part that both\n"
      "sides change differently is a conflict, and so is a part that is wrong with what the other side has done. Each\n"
      "is printed in one JSON line with the label of the predicate that does not hold; then nothing is written.\n\n" +
      exit_status("the merged scene is written", "there is a conflict", "the call or a file is bad") +
      examples({"merge base.json ours.json theirs.json -o merged.json"}));
  command->callback([options, &status] { status = merge(*options); });
}

}  // namespace durero::cli
