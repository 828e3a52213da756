#pragma once
/// A hierarchy of boxes is a tree. Each inner node has a box around everything below it and two children or more; each
/// leaf is one element. The builders of all hierarchies, of any arity, use these steps.

#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <limits>
#include <span>
#include <vector>

#include "durero/accel/large_pages.hpp"
#include "durero/scene/element_ref.hpp"
#include "durero/surface/bounds.hpp"

namespace durero::accel {

/// The least box around two.
inline surface::Box around(const surface::Box& a, const surface::Box& b) {
  return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

/// The surface of a box, over the numbers N: exact where those are.
template <class N>
N area(const surface::Box& box) {
  const N x = N(box.high.x) - N(box.low.x), y = N(box.high.y) - N(box.low.y), z = N(box.high.z) - N(box.low.z);
  return N(2) * (x * y + y * z + z * x);
}

/// The tree. A node has a number until it is taken out.
class Hierarchy {
 public:
  using Number = std::uint32_t;  ///< of a node
  /// The number of no node.
  static constexpr Number none = std::numeric_limits<Number>::max();

  /// A leaf or an inner node.
  struct Node {
    surface::Box box;             ///< around all that is below
    Number parent = none;         ///< `none` for the root
    Number child = none;          ///< the first child; `none` for a leaf
    Number next = none;           ///< the next child of the parent; `none` for the last
    std::uint32_t arity = 0;      ///< the number k of children; 0 for a leaf
    std::uint32_t leaves = 1;     ///< the number of leaves below, 1 for a leaf
    scene::ElementRef element{};  ///< of a leaf
    /// Whether the node is a leaf.
    bool is_leaf() const noexcept { return child == none; }
  };

  /// Whether there is no node.
  bool empty() const noexcept { return root_ == none; }
  /// The root's number, or `none` where there is no node.
  Number root() const noexcept { return root_; }
  /// A node.
  const Node& operator[](Number node) const noexcept { return nodes_[node]; }

  /// Calls visit(child) for each child of a node, in order, until it answers true. Whether it did.
  template <class Visit>
  bool any_child(Number node, Visit visit) const {
    for (Number child = nodes_[node].child; child != none; child = nodes_[child].next)
      if (visit(child)) return true;
    return false;
  }

  /// Calls visit(node) for each node, parents before children.
  template <class Visit>
  void for_each(Visit visit) const {
    std::vector<Number> left;
    if (!empty()) left.push_back(root_);
    while (!left.empty()) {
      const Number node = left.back();
      left.pop_back();
      visit(nodes_[node]);
      any_child(node, [&](Number child) {
        left.push_back(child);
        return false;
      });
    }
  }

  /// Makes a leaf that has no place yet.
  Number leaf(scene::ElementRef element, const surface::Box& box);
  /// Makes an inner node that has no place yet. Precondition: two children or more, all without a place.
  Number join(std::span<const Number> children);
  /// Makes a node without a place the root. Precondition: there is no root, or it has a parent now.
  void set_root(Number node);

  // Preconditions of both: `node` has no place; the other node has one, and is an inner node in put_under.
  /// Makes a node a child of another.
  void put_under(Number parent, Number node);
  /// Replaces a node by a new one with both as children.
  void put_beside(Number place, Number node);

  /// Takes out a leaf, whose number becomes free. A parent that is left with one child gives its place to it, and the
  /// boxes above shrink to fit.
  void take_out(Number leaf);
  /// Takes out an inner node that is not the root. Its children become its parent's.
  void dissolve(Number node);
  /// Gives another name to a leaf's element.
  void rename(Number leaf, scene::ElementRef element) noexcept { nodes_[leaf].element = element; }
  /// Gives another box to a leaf, and fits the boxes above.
  void refit(Number leaf, const surface::Box& box);

  /// Renumbers the nodes from 0 on without a gap, so that the children of a node, and neighbours in the tree, are near
  /// in memory. Earlier numbers become invalid. Precondition: every node has a place.
  void arrange();
  /// An upper bound of the nodes' numbers; right after arrange() each lesser number is a node's.
  Number numbers() const noexcept { return static_cast<Number>(nodes_.size()); }

  /// The greatest number of steps from the root to a leaf.
  std::size_t depth() const;
  /// The number of inner nodes.
  std::size_t inner_nodes() const;
  /// The memory in bytes.
  std::size_t bytes() const noexcept;

 private:
  Number add(const Node& node);
  void replace(Number old, Number by);
  void detach(Number child);
  void attach(Number parent, Number child);
  void fit(Number node);
  void fit_upwards(Number node);
  void grow_upwards(Number node, const surface::Box& by, std::uint32_t leaves);
  void shrink_upwards(Number node, surface::Box gone);

  using Nodes = std::vector<Node, LargePages<Node>>;

  Nodes nodes_;
  std::vector<Number> free_;
  Number root_ = none;
};

/// Σ k·A over all nodes, with k their children and A their surface: the cost by Goldsmith and Salmon times the surface
/// of the root. Leaves cost nothing.
template <class N>
N weight(const Hierarchy& tree) {
  N sum(0);
  tree.for_each([&](const Hierarchy::Node& node) {
    if (!node.is_leaf()) sum = sum + N(static_cast<int>(node.arity)) * area<N>(node.box);
  });
  return sum;
}

}  // namespace durero::accel
