#include "durero/accel/octree_names.hpp"

namespace durero::accel {

OctreeNames::OctreeNames(const Octree& octree, std::size_t lists) : octree_(octree), table_(lists) {
  for (std::uint32_t leaf = 0; leaf < octree.leaves().size(); ++leaf) {
    if (octree.lists()[leaf].empty()) continue;
    const Octree::Leaf& at = octree.leaves()[leaf];
    for (int depth = 0; depth < at.depth; ++depth) enter(name(at, depth), inner);
    enter(name(at, at.depth), leaf);
  }
}

OctreeNames::Name OctreeNames::name(const Octree::Leaf& leaf, int depth) const {
  Name name = root_name;
  for (int level = 1; level <= depth; ++level) name = child(name, octree_.octal_digit(leaf.corner, level) + 1);
  return name;
}

const OctreeNames::Entry* OctreeNames::entry(Name name) const {
  for (const Entry& entry : table_[name % table_.size()]) {
    if (entry.name == name) return &entry;
  }
  return nullptr;
}

void OctreeNames::enter(Name name, std::uint32_t leaf) {
  if (entry(name) == nullptr) table_[name % table_.size()].push_back({name, leaf});
}

std::optional<std::size_t> OctreeNames::find(Name name) const {
  const Entry* const found = entry(name);
  if (found == nullptr || found->leaf == inner) return {};
  return found->leaf;
}

std::optional<std::size_t> OctreeNames::leaf_at(const glm::dvec3& point, std::size_t& probes) const {
  Name name = root_name;
  glm::dvec3 low = octree_.finest().low;
  double half = octree_.finest().h * octree_.finest().count.x / 2;
  const Entry* found = entry(name);
  for (++probes; found != nullptr && found->leaf == inner; ++probes, half /= 2) {
    unsigned digit = 1;
    for (int axis = 0; axis < 3; ++axis) {
      if (point[axis] < low[axis] + half) continue;
      low[axis] += half;
      digit += 1u << axis;
    }
    name = child(name, digit);
    found = entry(name);
  }
  if (found == nullptr) return {};
  return found->leaf;
}

std::size_t OctreeNames::longest_chain() const {
  std::size_t longest = 0;
  for (const std::vector<Entry>& list : table_) longest = std::max(longest, list.size());
  return longest;
}

std::size_t OctreeNames::names() const {
  std::size_t names = 0;
  for (const std::vector<Entry>& list : table_) names += list.size();
  return names;
}

}  // namespace durero::accel
