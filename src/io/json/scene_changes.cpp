#include "durero/io/json/scene_changes.hpp"

#include <fmt/format.h>

#include <array>
#include <map>

#include "durero/io/json/groups_file.hpp"
#include "durero/io/json/json_writer.hpp"

namespace durero::io {
namespace {

enum class ChangeWord : std::uint8_t { added, removed, changed };
constexpr std::array<std::string_view, 3> change_words{"added", "removed", "changed"};

ChangeWord word_of(const PartChange& change) {
  if (!change.from) return ChangeWord::added;
  return change.to ? ChangeWord::changed : ChangeWord::removed;
}

}  // namespace

std::vector<PartChange> part_changes(const scene::GroupedScene& from, const scene::GroupedScene& to) {
  SceneParts before = scene_parts(from), after = scene_parts(to);
  std::vector<PartChange> changes;
  auto a = before.begin();
  auto b = after.begin();
  while (a != before.end() || b != after.end()) {
    const bool is_removed = b == after.end() || (a != before.end() && a->first < b->first);
    const bool is_added = !is_removed && (a == before.end() || b->first < a->first);
    if (is_removed) {
      changes.push_back({a->first, std::move(a->second), {}});
    } else if (is_added) {
      changes.push_back({b->first, {}, std::move(b->second)});
    } else if (a->second != b->second) {
      changes.push_back({a->first, std::move(a->second), std::move(b->second)});
    }
    if (!is_added) ++a;
    if (!is_removed) ++b;
  }
  return changes;
}

std::string change_text(const PartChange& change) {
  std::string text;
  json::Writer out(text);
  out.begin_object().member("part", change.part.pointer());
  out.member("change", change_words[static_cast<std::size_t>(word_of(change))]);
  if (change.from) text.append(",\"from\":").append(on_one_line(*change.from));
  if (change.to) text.append(",\"to\":").append(on_one_line(*change.to));
  return text + "}";
}

std::string changes_summary(const std::vector<PartChange>& changes) {
  std::map<PartKind, std::array<std::size_t, change_words.size()>> counts;
  for (const PartChange& change : changes) ++counts[change.part.kind][static_cast<std::size_t>(word_of(change))];
  std::string text;
  for (const auto& [kind, of] : counts)
    text += fmt::format("{}: {} added, {} removed, {} changed\n", key_of(kind), of[0], of[1], of[2]);
  return text;
}

std::string on_one_line(std::string value) {
  std::erase(value, '\n');  // a string holds none: the writer escapes it
  return value;
}

}  // namespace durero::io
