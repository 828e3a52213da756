#include "durero/io/json/scene_merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/json_pointer.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/json/scene_changes.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/json/scene_parts.hpp"

namespace durero::io {
namespace {

using Value = std::optional<std::string>;

Value value_in(const SceneParts& parts, const PartKey& key) {
  const auto found = parts.find(key);
  return found == parts.end() ? std::nullopt : Value(found->second);
}

/// The first two steps of a pointer. A part that one step leads to is of one side as it is, and nothing is wrong in it.
std::string part_of(const std::string& pointer) {
  const std::size_t whole = std::min(pointer.find('/', 1), pointer.size());
  return pointer.substr(0, std::min(pointer.find('/', whole + 1), pointer.size()));
}

/// Two changes of the parts of a scene.
class PartsMerge {
 public:
  PartsMerge(const scene::GroupedScene& base, const scene::GroupedScene& ours, const scene::GroupedScene& theirs)
      : base_(scene_parts(base)), ours_(scene_parts(ours)), theirs_(scene_parts(theirs)) {}

  SceneMerge merge() {
    SceneParts all = base_;
    all.insert(ours_.begin(), ours_.end());
    all.insert(theirs_.begin(), theirs_.end());
    for (const auto& [key, value] : all) settle(key);
    if (conflicts_.empty()) read_merged();
    return {std::move(merged_), std::move(conflicts_)};
  }

 private:
  void settle(const PartKey& key) {
    Value before = value_in(base_, key), left = value_in(ours_, key), right = value_in(theirs_, key);
    if (left != right && left != before && right != before) {
      const contract::clause& violated = left && right ? merge_pre_1 : merge_pre_2;
      conflicts_.push_back({&violated, key.pointer(), {}, std::move(before), std::move(left), std::move(right)});
      return;
    }
    const Value& stands = left == before ? right : left;
    if (stands) standing_.emplace_hint(standing_.end(), key, *stands);
  }

  /// Reads the parts that stand, as every scene is read.
  void read_merged() {
    const Source text("the merged scene", parts_text(standing_));
    std::vector<InputError> errors;
    read_scene(text, errors, Bodies::read);
    if (errors.empty()) {
      merged_ = read_grouped_scene(text, Bodies::read);
      return;
    }
    const std::vector<std::string> pointers = json::pointers_in_order(text, errors);
    const auto known = places();
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const auto part = known.find(part_of(pointers[i]));
      note_error(errors[i], pointers[i], part == known.end() ? nullptr : part->second);
    }
  }

  /// The conflict of an error in a part, or at a pointer that is in none.
  void note_error(const InputError& error, const std::string& pointer, const PartKey* key) {
    const contract::clause& violated = error.broken() == nullptr ? merge_pre_3 : *error.broken();
    MergeConflict conflict{&violated, pointer, std::string(error.message())};
    if (key != nullptr) {
      conflict.part = key->pointer();
      conflict.base = value_in(base_, *key);
      conflict.ours = value_in(ours_, *key);
      conflict.theirs = value_in(theirs_, *key);
    }
    conflicts_.push_back(std::move(conflict));
  }

  /// Where each part stands in the merged text.
  std::map<std::string, const PartKey*> places() const {
    std::map<std::string, const PartKey*> places;
    std::size_t number = 0;
    PartKind kind{};
    for (const auto& [key, value] : standing_) {
      number = key.kind == kind ? number : 0;
      kind = key.kind;
      const bool is_numbered = kind == PartKind::elementos || kind == PartKind::mallas;
      places[is_numbered ? fmt::format("/{}/{}", key_of(kind), number++) : key.pointer()] = &key;
    }
    return places;
  }

  SceneParts base_, ours_, theirs_, standing_{};
  std::vector<MergeConflict> conflicts_{};
  std::optional<scene::GroupedScene> merged_{};
};

}  // namespace

SceneMerge merged_scene(const scene::GroupedScene& base, const scene::GroupedScene& ours,
                        const scene::GroupedScene& theirs) {
  return PartsMerge(base, ours, theirs).merge();
}

std::string conflict_text(const MergeConflict& conflict) {
  std::string text;
  json::Writer out(text);
  out.begin_object().member("part", conflict.part);
  out.member("violated", conflict.violated->label).member("predicate", conflict.violated->predicate);
  if (conflict.message) out.member("message", *conflict.message);
  const auto add = [&](const char* side, const Value& value) {
    if (value) text.append(",\"").append(side).append("\":").append(on_one_line(*value));
  };
  add("base", conflict.base);
  add("ours", conflict.ours);
  add("theirs", conflict.theirs);
  return text + "}";
}

}  // namespace durero::io
