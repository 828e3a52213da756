#pragma once
/// A hierarchy of boxes: a tree whose inner nodes have a box around all that is below, and two children or more; each
/// leaf is one element. Whoever builds one, of whatever arity, builds it of these steps.

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

/// The tree. Nodes are known by number, until they are taken out.
class Hierarchy {
 public:
  using Number = std::uint32_t;  ///< of a node
  /// Of no node.
  static constexpr Number none = std::numeric_limits<Number>::max();

  /// Leaf or inner node.
  struct Node {
    surface::Box box;             ///< around all that is below
    Number parent = none;         ///< none of the root
    Number child = none;          ///< the first; none of a leaf
    Number next = none;           ///< of the same parent; none of the last
    std::uint32_t arity = 0;      ///< how many children: k; 0 of a leaf
    std::uint32_t leaves = 1;     ///< below, or itself
    scene::ElementRef element{};  ///< of a leaf
    /// It stands for one element.
    bool is_leaf() const noexcept { return child == none; }
  };

  /// Of no node at all.
  bool empty() const noexcept { return root_ == none; }
  /// none where it is empty.
  Number root() const noexcept { return root_; }
  /// A node.
  const Node& operator[](Number node) const noexcept { return nodes_[node]; }

  /// visit(child) for each child of a node, in order, until it answers true. Whether it did.
  template <class Visit>
  bool any_child(Number node, Visit visit) const {
    for (Number child = nodes_[node].child; child != none; child = nodes_[child].next)
      if (visit(child)) return true;
    return false;
  }

  /// visit(node) for each node, each before those below it.
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

  /// A leaf that has no place yet.
  Number leaf(scene::ElementRef element, const surface::Box& box);
  /// An inner node that has no place yet. Precondition: two children or more, without a place.
  Number join(std::span<const Number> children);
  /// Makes a node without a place the root. Precondition: there is none, or it has got a place since.
  void set_root(Number node);

  // Preconditions of both: the node has no place; the other one has, and is inner where it becomes a parent.
  /// The node becomes a child of another.
  void put_under(Number parent, Number node);
  /// A new node takes the place of another, and has both as its children.
  void put_beside(Number place, Number node);

  /// Takes a leaf out, whose number is free from then on; a parent that is left with one child gives its place to it;
  /// the boxes above shrink to what they hold.
  void take_out(Number leaf);
  /// Takes out an inner node that is not the root: its children become its parent's.
  void dissolve(Number node);
  /// The leaf's element goes by another reference now.
  void rename(Number leaf, scene::ElementRef element) noexcept { nodes_[leaf].element = element; }
  /// The leaf's element has another box: those above are made anew.
  void refit(Number leaf, const surface::Box& box);

  /// Numbers the nodes anew, from 0 on without a gap: the children of a node stand together, and what is near in the
  /// tree is near in memory. Numbers of before name nothing any more. Precondition: every node has a place.
  void arrange();
  /// The numbers of nodes are less than this. Right after arrange() each of them is one of a node.
  Number numbers() const noexcept { return static_cast<Number>(nodes_.size()); }

  /// The longest way from the root to a leaf, in steps.
  std::size_t depth() const;
  /// Inner nodes.
  std::size_t inner_nodes() const;
  /// Of memory.
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

/// Σ k·A over all nodes, k their children and A their surface: the cost of the hierarchy by Goldsmith and Salmon,
/// times the surface of its root. Leaves cost nothing.
template <class N>
N weight(const Hierarchy& tree) {
  N sum(0);
  tree.for_each([&](const Hierarchy::Node& node) {
    if (!node.is_leaf()) sum = sum + N(static_cast<int>(node.arity)) * area<N>(node.box);
  });
  return sum;
}

}  // namespace durero::accel
