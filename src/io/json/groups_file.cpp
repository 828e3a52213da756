#include "durero/io/json/groups_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "durero/io/json/scene_file.hpp"
#include "durero/model/tipos.hpp"
#include "durero/text/shown.hpp"
#include "groups_reader.hpp"

namespace durero::io {
namespace {

using Clause = contract::clause;
using Names = std::set<std::string_view>;

constexpr std::string_view group_keys[] = {"elementos", "groups"};

[[noreturn]] void fail(const json::Reader& in, const NamePlace& at, std::string_view what, const Clause& broken) {
  in.fail(at.offset, fmt::format("{} {}", text::shown(at.name), what),
          fmt::format("expected {} ({})", broken.predicate, broken.label), &broken);
}

NamePlace checked_name(const json::Reader& in, std::string_view name, std::size_t offset) {
  if (!model::Elemento::is_name(std::string(name)))
    in.fail(offset, fmt::format("{} names nothing", text::shown(name)), "expected 1 to 128 of A-Z a-z 0-9 _ . : -");
  return {std::string(name), offset};
}

std::vector<NamePlace> read_members(json::Reader& in, std::string_view what) {
  std::vector<NamePlace> members;
  in.array(what, [&] {
    const std::size_t at = in.offset();
    members.push_back(checked_name(in, in.string("a name"), at));
  });
  return members;
}

/// No member is one of two groups, or twice of one.
void check_once(const json::Reader& in, const NamePlace& member, Names& seen, const Clause& broken) {
  if (!seen.insert(member.name).second) fail(in, member, "is in a group already", broken);
}

void check_members(const json::Reader& in, const std::vector<WrittenGroup>& written, const scene::Scene& scene) {
  Names names, elementos, groups;
  for (const WrittenGroup& group : written) names.insert(group.name.name);
  for (const WrittenGroup& group : written) {
    for (const NamePlace& e : group.elementos) {
      if (!scene.find(e.name)) fail(in, e, "is no element", scene::group_pre_2);
      check_once(in, e, elementos, scene::group_pre_4);
    }
    for (const NamePlace& g : group.groups) {
      if (!names.contains(g.name)) fail(in, g, "is no group", scene::group_pre_3);
      check_once(in, g, groups, scene::group_pre_5);
    }
  }
}

scene::Names names_of(const std::vector<NamePlace>& members) {
  scene::Names names;
  for (const NamePlace& member : members) names.insert(member.name);
  return names;
}

}  // namespace

std::vector<WrittenGroup> read_written_groups(json::Reader& in) {
  std::vector<WrittenGroup> written;
  Names seen;
  in.members("groups", [&](const json::Key& key) {
    if (!seen.insert(key.name).second)
      in.fail(key.offset, fmt::format("group {} stands twice", text::shown(key.name)), "expected it once");
    WrittenGroup& group = written.emplace_back();
    group.name = checked_name(in, key.name, key.offset);
    in.object("a group", group_keys, 0, [&](std::size_t i) {
      const std::string_view what = group_keys[i];
      (i == 0 ? group.elementos : group.groups) = read_members(in, what);
    });
  });
  return written;
}

/// From small to large: from each group that holds no other upwards, as the last group in another is made. What is left
/// then lies within itself.
scene::Groups make_groups(const json::Reader& in, const std::vector<WrittenGroup>& written, const scene::Scene& scene) {
  scene::Groups groups;
  check_members(in, written, scene);
  std::map<std::string_view, std::size_t> left, above;  // groups in it that are not made yet; the group that it is in
  std::vector<std::size_t> ready;
  for (std::size_t i = 0; i < written.size(); ++i) {
    left[written[i].name.name] = written[i].groups.size();
    for (const NamePlace& g : written[i].groups) above[g.name] = i;
    if (written[i].groups.empty()) ready.push_back(i);
  }
  for (std::size_t made = 0; made < ready.size(); ++made) {
    const WrittenGroup& group = written[ready[made]];
    groups.apply_total(scene::Grouping{group.name.name, {names_of(group.elementos), names_of(group.groups)}}, scene);
    const auto found = above.find(group.name.name);
    if (found != above.end() && --left[written[found->second].name.name] == 0) ready.push_back(found->second);
  }
  const auto circle = std::ranges::find_if(written, [&](const WrittenGroup& g) { return left[g.name.name] > 0; });
  if (circle != written.end()) fail(in, circle->name, "lies within itself, or holds what does", scene::groups_inv_1);
  return groups;
}

scene::Groups read_groups(const Source& source, const scene::Scene& scene) {
  const json::Document document(source);
  const json::Reader in(document);
  auto groups = in.member("groups");
  return groups ? make_groups(in, read_written_groups(*groups), scene) : scene::Groups();
}

}  // namespace durero::io
