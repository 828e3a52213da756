#include "durero/accel/names.hpp"

#include <algorithm>

namespace durero::accel {

void NameTable::enter(Name name, std::uint32_t leaf) {
  if (!find(name)) lists_[name % lists_.size()].push_back({name, leaf});
}

std::optional<std::uint32_t> NameTable::find(Name name) const {
  for (const Entry& entry : lists_[name % lists_.size()]) {
    if (entry.name == name) return entry.leaf;
  }
  return {};
}

std::size_t NameTable::longest_chain() const {
  std::size_t longest = 0;
  for (const std::vector<Entry>& list : lists_) longest = std::max(longest, list.size());
  return longest;
}

std::size_t NameTable::names() const {
  std::size_t names = 0;
  for (const std::vector<Entry>& list : lists_) names += list.size();
  return names;
}

OctreeNames::OctreeNames(const Octree& octree, std::size_t lists) : octree_(octree), table_(lists) {
  for (std::uint32_t leaf = 0; leaf < octree.leaves().size(); ++leaf) {
    if (octree.lists()[leaf].empty()) continue;
    const Octree::Leaf& at = octree.leaves()[leaf];
    for (int depth = 0; depth < at.depth; ++depth) table_.enter(name(at, depth), NameTable::inner);
    table_.enter(name(at, at.depth), leaf);
  }
}

Name OctreeNames::name(const Octree::Leaf& leaf, int depth) const {
  Name name = root_name;
  for (int level = 1; level <= depth; ++level) name = child(name, octree_.octal_digit(leaf.corner, level) + 1);
  return name;
}

std::optional<std::uint32_t> OctreeNames::leaf_at(const glm::dvec3& point, std::size_t& probes) const {
  glm::dvec3 low = octree_.finest().low;
  double half = octree_.finest().h * octree_.finest().count.x / 2;
  Name name = root_name;
  std::optional<std::uint32_t> found = table_.find(name);
  for (++probes; found == NameTable::inner; ++probes, half /= 2) {
    unsigned digit = 1;
    for (int axis = 0; axis < 3; ++axis) {
      if (point[axis] < low[axis] + half) continue;
      low[axis] += half;
      digit += 1u << axis;
    }
    name = child(name, digit);
    found = table_.find(name);
  }
  return found;
}

BspNames::BspNames(const Bsp& bsp, std::size_t lists) : bsp_(bsp), table_(lists) {
  std::vector<Name> names(bsp.nodes().size(), root_name);
  for (std::uint32_t place = 0; place < names.size(); ++place) {
    table_.enter(names[place], place);
    const Bsp::Node& node = bsp.nodes()[place];
    if (node.leaf()) continue;
    names[node.below] = child(names[place], false);
    names[node.below + 1] = child(names[place], true);
  }
}

std::uint32_t BspNames::leaf_at(const glm::dvec3& point) const {
  Name name = root_name;
  for (;;) {
    const Bsp::Node& node = bsp_.nodes()[*table_.find(name)];
    if (node.leaf()) return node.below;
    name = child(name, point[static_cast<int>(node.axis)] >= node.plane);
  }
}

}  // namespace durero::accel
