#include "durero/scene/groups.hpp"

#include <algorithm>
#include <utility>

#include "durero/scene/edit.hpp"
#include "durero/scene/scene.hpp"

namespace durero::scene {
namespace {

using Members = std::map<std::string, std::string, std::less<>>;

/// Each member with the name of its group, to be merged into an index: what asks for memory comes before the edit.
Members members_of(const Names& names, std::string_view group) {
  Members members;
  for (const std::string& name : names) members.emplace_hint(members.end(), name, group);
  return members;
}

void forget(Members& members, const Names& names) noexcept {
  for (const std::string& name : names) members.erase(members.find(name));
}

std::string_view found(const Members& members, std::string_view name) noexcept {
  const auto at = members.find(name);
  return at == members.end() ? std::string_view() : at->second;
}

}  // namespace

std::string_view Groups::of_element(std::string_view name) const noexcept { return found(of_element_, name); }
std::string_view Groups::of_group(std::string_view name) const noexcept { return found(of_group_, name); }

std::vector<std::string_view> Groups::bottom_up() const {
  std::vector<std::string_view> order;
  for (const auto& [name, group] : table_)
    if (!of_group_.contains(name)) order.push_back(name);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (const std::string& within : table_.find(order[i])->second.groups) order.push_back(within);
  std::ranges::reverse(order);
  return order;
}

Outcome Groups::apply_total(const GroupEdit& edit, const Scene& scene) {
  if (const auto* ungrouping = std::get_if<Ungrouping>(&edit)) {
    if (!table_.contains(ungrouping->g)) return {"no_such_group", &ungroup_pre_1};
    dissolve(ungrouping->g);
    return {"ungrouped"};
  }
  const auto& in = std::get<Grouping>(edit);
  const auto is_element = [&](const std::string& name) { return scene.find(name).has_value(); };
  const auto is_group = [&](const std::string& name) { return table_.contains(name); };
  const auto is_placed = [](const Members& of) { return [&](const std::string& name) { return of.contains(name); }; };
  if (is_group(in.g)) return {"group_exists", &group_pre_1};
  if (!std::ranges::all_of(in.of.elementos, is_element)) return {"no_such_element", &group_pre_2};
  if (!std::ranges::all_of(in.of.groups, is_group)) return {"no_such_group", &group_pre_3};
  if (std::ranges::any_of(in.of.elementos, is_placed(of_element_))) return {"element_in_a_group", &group_pre_4};
  if (std::ranges::any_of(in.of.groups, is_placed(of_group_))) return {"group_in_a_group", &group_pre_5};
  make(in);
  return {"grouped"};
}

/// A group of groups that were made before it, and are in none, closes no circle: groups.inv.1 holds on.
void Groups::make(const Grouping& in) {
  Table one;
  one.emplace(in.g, in.of);
  Members elements = members_of(in.of.elementos, in.g), groups = members_of(in.of.groups, in.g);
  table_.merge(one);
  of_element_.merge(elements);
  of_group_.merge(groups);
}

void Groups::dissolve(std::string_view g) {
  const auto at = table_.find(g);
  Group& group = at->second;
  const auto above = table_.find(of_group(g));
  Members elements, groups;
  if (above != table_.end()) {
    elements = members_of(group.elementos, above->first);
    groups = members_of(group.groups, above->first);
  }
  forget(of_element_, group.elementos);
  forget(of_group_, group.groups);
  if (above != table_.end()) {
    of_element_.merge(elements);
    of_group_.merge(groups);
    above->second.groups.erase(at->first);
    above->second.elementos.merge(group.elementos);
    above->second.groups.merge(group.groups);
    of_group_.erase(at->first);
  }
  table_.erase(at);
}

Groups::Index::iterator Groups::leave(Index::iterator element) noexcept {
  Names& elements = table_.find(element->second)->second.elementos;
  elements.erase(elements.find(element->first));
  return of_element_.erase(element);
}

void Groups::put(const std::string& element, std::string_view group) {
  const auto into = table_.find(group);
  if (into->first == of_element(element)) return;
  Names one{element};
  Members member = members_of(one, into->first);
  take_out(element);
  into->second.elementos.merge(one);
  of_element_.merge(member);
}

void Groups::take_out(std::string_view element) noexcept {
  const auto at = of_element_.find(element);
  if (at != of_element_.end()) leave(at);
}

void Groups::follow(const model::Operation& done) noexcept { take_out(name_of(done).name()); }

void Groups::follow_meshes(const Scene& scene) noexcept {
  for (auto at = of_element_.begin(); at != of_element_.end();) at = scene.find(at->first) ? std::next(at) : leave(at);
}

}  // namespace durero::scene
