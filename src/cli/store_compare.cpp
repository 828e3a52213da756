// durero store diff and merge: two revisions of one store compared, and put together.
#include <fmt/format.h>

#include <memory>

#include "description.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/scene_changes.hpp"
#include "durero/io/json/scene_merge.hpp"
#include "durero/io/json/scene_patch.hpp"
#include "durero/io/json/scene_script.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/scene/stage.hpp"
#include "store.hpp"

namespace durero::cli {
namespace {

struct StoreDiff {
  std::string store, from, to = "HEAD";
  bool json_patch = false, summary = false;
};

int diff_revisions(const StoreDiff& call) {
  store::Store of(call.store, store::StoreAccess::read);
  const scene::GroupedScene from = of.state(of.find(call.from)), to = of.state(of.find(call.to));
  if (call.json_patch) {
    const std::string patch = io::scene_patch(from, to);
    io::print(patch);
    return patch == io::empty_patch ? 0 : 1;
  }
  if (call.summary) {
    const std::string summary = io::changes_summary(io::part_changes(from, to));
    io::print(summary);
    return summary.empty() ? 0 : 1;
  }
  const io::SceneScript script = io::script_between(from, to);
  if (!script.beyond.empty())
    throw io::FileError(of.path(), fmt::format("no operation makes {} so", script.beyond.front()),
                        "expected --json-patch or --summary, which say every difference");
  io::print(io::script_text(script, from.scene.stage()));
  return script.steps.empty() ? 0 : 1;
}

struct StoreMerge {
  std::string store, theirs;
  store::Provenance by;
};

/// Puts a scene where HEAD is: by the operations that make it, or whole, where none do.
void put_merged(store::Store& of, const scene::GroupedScene& ours, scene::GroupedScene merged,
                const store::Provenance& by, store::EventNumber head) {
  const io::SceneScript script = io::script_between(ours, merged);
  if (!script.beyond.empty()) {
    of.import(std::move(merged), "", by);
    return;
  }
  if (script.steps.empty()) return;
  const io::Source text("the script of the merge", io::script_text(script, ours.scene.stage()));
  store::EditCall call{text};
  call.by = by;
  call.all_or_nothing = true;
  call.expected_head = head;
  if (of.edit(call).is_refused) throw std::logic_error("the script of a merge was refused");
}

int merge_revision(StoreMerge call) {
  store::Store of(call.store, store::StoreAccess::write);
  if (call.by.comment.empty()) call.by.comment = "merge " + call.theirs;
  const store::EventNumber head = of.head().event, other = of.find(call.theirs);
  const scene::GroupedScene base = of.state(of.common_ancestor(head, other)), ours = of.state(head),
                            theirs = of.state(other);
  io::SceneMerge merge = io::merged_scene(base, ours, theirs);
  if (!merge.scene) {
    for (const io::MergeConflict& conflict : merge.conflicts) io::print(io::conflict_text(conflict) + "\n");
    return 1;
  }
  put_merged(of, ours, *std::move(merge.scene), provenance_of(call.by), head);
  io::print(where_text(of) + "\n");
  return 0;
}

void add_store_diff(CLI::App& store, int& status) {
  auto* command = store.add_subcommand("diff", "The operations that make the scene of one revision of another's");
  const auto call = std::make_shared<StoreDiff>();
  add_store_path(*command, call->store);
  command->add_option("FROM", call->from, "The revision before")->required();
  command->add_option("TO", call->to, "The revision after; without it HEAD");
  auto* const patch = command->add_flag("--json-patch", call->json_patch, "Print a JSON Patch of the canonical text");
  command->add_flag("--summary", call->summary, "Print how many parts of each kind were added, removed and changed")
      ->excludes(patch);
  command->footer(exit_status("the scenes are the same", "they differ",
                              "the call or the store is bad, or no operation makes a difference") +
                  examples({"store diff room.store HEAD~1", "store diff room.store main spring --summary"}));
  command->callback([call, &status] { status = diff_revisions(*call); });
}

void add_store_merge(CLI::App& store, int& status) {
  auto* command = store.add_subcommand("merge", "Put what another revision has changed into HEAD's scene");
  const auto call = std::make_shared<StoreMerge>();
  add_store_path(*command, call->store);
  command->add_option("REV", call->theirs, "A branch, a tag, or another revision")->required();
  add_provenance(*command, call->by);
  command->footer(
      "Both are compared with the last event that both come from, part by part, as durero merge does. The operations\n"
      "that the other revision stands for are one transaction behind HEAD. Where both have changed one part "
      "otherwise,\n"
      "each conflict is printed in one JSON line, and nothing is kept.\n\n" +
      exit_status("HEAD has both changes", "there is a conflict", "the call or the store is bad") +
      examples({"store merge room.store spring"}));
  command->callback([call, &status] { status = merge_revision(*call); });
}

}  // namespace

void add_store_compare(CLI::App& command, int& status) {
  add_store_diff(command, status);
  add_store_merge(command, status);
}

}  // namespace durero::cli
