#include "durero/accel/hierarchy.hpp"

#include <algorithm>
#include <array>
#include <glm/vector_relational.hpp>

namespace durero::accel {
namespace {

/// Whether a box within another reaches one of its faces.
bool reaches_a_face(const surface::Box& inner, const surface::Box& outer) {
  return glm::any(glm::equal(inner.low, outer.low)) || glm::any(glm::equal(inner.high, outer.high));
}

}  // namespace

Hierarchy::Number Hierarchy::add(const Node& node) {
  if (free_.empty()) {
    // The capacity grows by a quarter, not twofold, because unused capacity counts as memory of the tree.
    if (nodes_.size() == nodes_.capacity()) nodes_.reserve(nodes_.size() + nodes_.size() / 4 + 16);
    nodes_.push_back(node);
    return static_cast<Number>(nodes_.size() - 1);
  }
  const Number number = free_.back();
  free_.pop_back();
  nodes_[number] = node;
  return number;
}

Hierarchy::Number Hierarchy::leaf(scene::ElementRef element, const surface::Box& box) {
  return add({.box = box, .element = element});
}

Hierarchy::Number Hierarchy::join(std::span<const Number> children) {
  const Number node = add({.box = nodes_[children.front()].box, .leaves = 0});
  for (const Number child : children) attach(node, child);
  fit(node);
  return node;
}

void Hierarchy::set_root(Number node) { root_ = node; }

void Hierarchy::put_under(Number parent, Number node) {
  attach(parent, node);
  grow_upwards(parent, nodes_[node].box, nodes_[node].leaves);
}

void Hierarchy::put_beside(Number place, Number node) {
  const Number both = add({.box = nodes_[place].box, .leaves = nodes_[place].leaves});
  replace(place, both);
  attach(both, place);
  attach(both, node);
  grow_upwards(both, nodes_[node].box, nodes_[node].leaves);
}

void Hierarchy::take_out(Number leaf) {
  const Number parent = nodes_[leaf].parent;
  free_.push_back(leaf);
  if (parent == none) {
    root_ = none;
    return;
  }
  detach(leaf);
  if (nodes_[parent].arity > 1) return shrink_upwards(parent, nodes_[leaf].box);
  const Number only = nodes_[parent].child, above = nodes_[parent].parent;
  detach(only);
  replace(parent, only);
  free_.push_back(parent);
  shrink_upwards(above, nodes_[parent].box);
}

void Hierarchy::dissolve(Number node) {
  const Number parent = nodes_[node].parent;
  detach(node);
  while (!nodes_[node].is_leaf()) {
    const Number child = nodes_[node].child;
    detach(child);
    attach(parent, child);
  }
  free_.push_back(node);
}

void Hierarchy::refit(Number leaf, const surface::Box& box) {
  nodes_[leaf].box = box;
  fit_upwards(nodes_[leaf].parent);
}

/// Gives the place of `old` to `by`, which has none; `old` has none then.
void Hierarchy::replace(Number old, Number by) {
  const Number parent = nodes_[old].parent;
  if (parent == none) {
    root_ = by;
    nodes_[by].parent = none;
    return;
  }
  detach(old);
  attach(parent, by);
}

void Hierarchy::attach(Number parent, Number child) {
  nodes_[child].parent = parent;
  nodes_[child].next = nodes_[parent].child;
  nodes_[parent].child = child;
  ++nodes_[parent].arity;
}

void Hierarchy::detach(Number child) {
  Node& parent = nodes_[nodes_[child].parent];
  Number* link = &parent.child;
  while (*link != child) link = &nodes_[*link].next;
  *link = nodes_[child].next;
  --parent.arity;
  nodes_[child].parent = nodes_[child].next = none;
}

/// Computes the box and the number of leaves of an inner node from its children.
void Hierarchy::fit(Number node) {
  nodes_[node].box = nodes_[nodes_[node].child].box;
  nodes_[node].leaves = 0;
  any_child(node, [&](Number child) {
    nodes_[node].box = around(nodes_[node].box, nodes_[child].box);
    nodes_[node].leaves += nodes_[child].leaves;
    return false;
  });
}

/// Adds leaves within a box to the nodes from `node` up to the root, whose boxes grow by that box alone.
void Hierarchy::grow_upwards(Number node, const surface::Box& by, std::uint32_t leaves) {
  for (; node != none; node = nodes_[node].parent) {
    nodes_[node].box = around(nodes_[node].box, by);
    nodes_[node].leaves += leaves;
  }
}

/// Fits the nodes from `node` up to the root after a leaf below is gone; a child of `node` had the box `gone`, and now
/// is smaller or no more. A box whose faces that child did not reach is determined by the other children and unchanged,
/// and so are the boxes above it.
void Hierarchy::shrink_upwards(Number node, surface::Box gone) {
  bool may_shrink = true;
  for (; node != none; node = nodes_[node].parent) {
    const surface::Box before = nodes_[node].box;
    may_shrink = may_shrink && reaches_a_face(gone, before);
    if (may_shrink)
      fit(node);
    else
      --nodes_[node].leaves;
    gone = before;
  }
}

void Hierarchy::fit_upwards(Number node) {
  for (; node != none; node = nodes_[node].parent) fit(node);
}

/// The nodes are copied family by family. A family comes before those of its members, and everything below the first
/// member before that below the second. `arranged` has new numbers, except for the children of the nodes in `left`,
/// which are old ones.
void Hierarchy::arrange() {
  Nodes arranged;
  arranged.reserve(nodes_.size() - free_.size());
  std::vector<Number> left;
  if (!empty()) {
    arranged.push_back(nodes_[root_]);
    left.push_back(root_ = 0);
  }
  while (!left.empty()) {
    const Number parent = left.back(), first = static_cast<Number>(arranged.size());
    left.pop_back();
    for (Number old = arranged[parent].child; old != none; old = nodes_[old].next) {
      arranged.push_back(nodes_[old]);
      arranged.back().parent = parent;
      arranged.back().next = nodes_[old].next == none ? none : static_cast<Number>(arranged.size());
    }
    if (first != arranged.size()) arranged[parent].child = first;
    for (Number node = static_cast<Number>(arranged.size()); node > first; --node) left.push_back(node - 1);
  }
  nodes_ = std::move(arranged);
  free_ = {};
}

std::size_t Hierarchy::depth() const {
  std::size_t deepest = 0;
  std::vector<std::pair<Number, std::size_t>> left;
  if (!empty()) left.emplace_back(root_, 0);
  while (!left.empty()) {
    const auto [node, depth] = left.back();
    left.pop_back();
    deepest = std::max(deepest, depth);
    any_child(node, [&, below = depth + 1](Number child) {
      left.emplace_back(child, below);
      return false;
    });
  }
  return deepest;
}

std::size_t Hierarchy::inner_nodes() const { return empty() ? 0 : nodes_.size() - free_.size() - nodes_[root_].leaves; }

std::size_t Hierarchy::bytes() const noexcept {
  return nodes_.capacity() * sizeof(Node) + free_.capacity() * sizeof(Number);
}

}  // namespace durero::accel
