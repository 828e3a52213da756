#pragma once
/// Goldsmith and Salmon's incremental construction: elements are inserted one by one, each where it adds least to the
/// cost of the hierarchy.
///
/// An insertion makes the element a child of a node, or replaces a node by a new one with both as children. Either
/// changes Σ k·A only in one node and in the boxes above it, so the increment is known without the rest of the tree. A
/// node with k children that gets one more adds k·(A_new − A_old) + A_new. The seed prints the first summand alone,
/// which leaves out the test of the new child itself, and would not add up to the cost.

#include <cstddef>
#include <vector>

#include "durero/accel/hierarchy.hpp"

namespace durero::accel {

/// A position for a new leaf, and its increment of the cost.
template <class N>
struct Position {
  enum class Kind : std::uint8_t { under, beside };  ///< a child of the node; or with it below a new node
  Hierarchy::Number node = Hierarchy::none;          ///< `none` where the tree is empty
  Kind kind = Kind::beside;                          ///< the relation to the node
  N increment = N(0);                                ///< of Σ k·A
  std::size_t examined = 0;                          ///< the number of nodes examined
};

/// Searches for the cheapest position of a box. Among equal costs it takes the position with the fewest leaves below,
/// which keeps a tree of equal boxes balanced. N is exact in tests; in binary64 a wrong choice costs time, and no
/// answer.
template <class N>
class Insertion {
 public:
  /// Searches a tree whose nodes have at most `most_children` children.
  Insertion(const Hierarchy& tree, const surface::Box& box, unsigned most_children)
      : tree_(tree), box_(box), most_children_(most_children) {}

  /// The best of all positions. Θ(n).
  Position<N> of_all() {
    std::vector<Reached> left;
    if (!tree_.empty()) left.push_back({tree_.root(), N(0)});
    while (!left.empty()) {
      const Reached at = left.back();
      left.pop_back();
      const N below = look_at(at);
      tree_.any_child(at.node, [&](Hierarchy::Number child) {
        left.push_back({child, below});
        return false;
      });
    }
    return best_;
  }

  /// The heuristic: the best position on the way from the root to a leaf along the cheapest child.
  Position<N> downwards() {
    if (tree_.empty()) return best_;
    Reached at{tree_.root(), N(0)};
    for (;;) {
      const N below = look_at(at);
      if (tree_[at.node].is_leaf()) return best_;
      at = {cheapest_child(at.node), below};
    }
  }

 private:
  struct Reached {
    Hierarchy::Number node;
    N inherited;  ///< the growth of the nodes above
  };

  N area_with(Hierarchy::Number node) const { return area<N>(around(tree_[node].box, box_)); }

  bool takes_one_more(const Hierarchy::Node& node) const { return !node.is_leaf() && node.arity < most_children_; }

  /// Considers both positions at a node. The increment that any insertion below it makes in it and above.
  N look_at(const Reached& at) {
    ++best_.examined;
    const Hierarchy::Node& node = tree_[at.node];
    const N grown = area_with(at.node);
    consider(at.node, Position<N>::Kind::beside, at.inherited + N(2) * grown);
    if (node.is_leaf()) return at.inherited;
    const N below = at.inherited + N(static_cast<int>(node.arity)) * (grown - area<N>(node.box));
    if (takes_one_more(node)) consider(at.node, Position<N>::Kind::under, below + grown);
    return below;
  }

  void consider(Hierarchy::Number node, typename Position<N>::Kind kind, const N& increment) {
    const bool better = best_.node == Hierarchy::none || increment < best_.increment ||
                        (increment == best_.increment && tree_[node].leaves < tree_[best_.node].leaves);
    if (!better) return;
    best_.node = node;
    best_.kind = kind;
    best_.increment = increment;
  }

  Hierarchy::Number cheapest_child(Hierarchy::Number parent) {
    Hierarchy::Number cheapest = Hierarchy::none;
    N least(0);
    tree_.any_child(parent, [&](Hierarchy::Number child) {
      const Hierarchy::Node& node = tree_[child];
      const N grown = area_with(child);
      const N cost =
          N(takes_one_more(node) ? 1 : 2) * grown + N(static_cast<int>(node.arity)) * (grown - area<N>(node.box));
      ++best_.examined;
      if (cheapest == Hierarchy::none || cost < least || (cost == least && node.leaves < tree_[cheapest].leaves)) {
        cheapest = child;
        least = cost;
      }
      return false;
    });
    return cheapest;
  }

  const Hierarchy& tree_;
  const surface::Box& box_;
  unsigned most_children_;
  Position<N> best_;
};

/// Puts a leaf that has no place at a position of the tree.
template <class N>
void put(Hierarchy& tree, const Position<N>& position, Hierarchy::Number leaf) {
  if (position.node == Hierarchy::none) return tree.set_root(leaf);
  if (position.kind == Position<N>::Kind::under) return tree.put_under(position.node, leaf);
  tree.put_beside(position.node, leaf);
}

}  // namespace durero::accel
