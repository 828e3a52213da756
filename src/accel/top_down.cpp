#include "accel/top_down.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace durero::accel {
namespace {

class TopDown {
  using Number = Hierarchy::Number;
  using Leaves = std::span<Number>;

 public:
  TopDown(Hierarchy& tree, unsigned most_children) : tree_(tree), most_children_(most_children) {}

  Number join(Leaves leaves, int depth) {
    if (leaves.size() == 1) return leaves.front();
    const std::size_t count = cut(leaves, depth);
    const std::array<Number, 2> halves{join(leaves.first(count), depth + 1), join(leaves.subspan(count), depth + 1)};
    const Number node = tree_.join(halves);
    for (const Number half : halves)
      if (gives_way(half)) tree_.dissolve(half);
    return node;
  }

 private:
  /// A cut of a set: its first `count` elements along the axis. The choice costs time, never answers.
  struct Cut {
    int axis;
    std::size_t count;
    double cost;
  };

  /// The depth from which on a set is halved. Elements of ever other sizes are separated two or three at a time, which
  /// would make a tree nearly as deep as they are many.
  static constexpr int deepest_by_area = 40;
  /// The number of leaves from which on only one axis is tried, along which the centres spread widest.
  static constexpr std::size_t many = 1024;

  double centre(Number leaf, int axis) const { return tree_[leaf].box.low[axis] + tree_[leaf].box.high[axis]; }

  void sort(Leaves leaves, int axis) const {
    std::sort(leaves.begin(), leaves.end(), [&](Number a, Number b) {
      const double x = centre(a, axis), y = centre(b, axis);
      return x != y ? x < y : a < b;
    });
  }

  double spread(Leaves leaves, int axis) const {
    const auto [least, greatest] = std::minmax_element(
        leaves.begin(), leaves.end(), [&](Number a, Number b) { return centre(a, axis) < centre(b, axis); });
    return centre(*greatest, axis) - centre(*least, axis);
  }

  /// Reorders the leaves so that the first part comes first. The size of the first part.
  std::size_t cut(Leaves leaves, int depth) {
    int widest = 0;
    for (int axis = 1; axis < 3; ++axis)
      if (spread(leaves, axis) > spread(leaves, widest)) widest = axis;
    if (depth >= deepest_by_area) {
      sort(leaves, widest);
      return leaves.size() / 2;
    }
    Cut best = best_along(leaves, widest);
    if (leaves.size() < many) {
      for (const int axis : {(widest + 1) % 3, (widest + 2) % 3}) {
        const Cut other = best_along(leaves, axis);
        if (other.cost < best.cost) best = other;
      }
      sort(leaves, best.axis);
    }
    return best.count;
  }

  /// The cheapest cut along an axis; among equal costs the one nearest to the middle.
  Cut best_along(Leaves leaves, int axis) {
    sort(leaves, axis);
    const std::size_t n = leaves.size();
    after_.resize(std::max(after_.size(), n));
    surface::Box box = tree_[leaves[n - 1]].box;
    for (std::size_t i = n - 1; i > 0; --i) {
      box = around(box, tree_[leaves[i]].box);
      after_[i] = area<double>(box);
    }
    const auto from_middle = [&](std::size_t i) { return std::abs(2 * double(i) - double(n)); };
    Cut best{axis, 0, 0};
    box = tree_[leaves[0]].box;
    for (std::size_t i = 1; i < n; ++i) {
      box = around(box, tree_[leaves[i - 1]].box);
      const double cost = area<double>(box) * double(i) + after_[i] * double(n - i);
      if (best.count == 0 || cost < best.cost || (cost == best.cost && from_middle(i) < from_middle(best.count)))
        best = {axis, i, cost};
    }
    return best;
  }

  /// Whether a child gives way to its children. Its parent, of surface A, then costs k·A more and A less, and the
  /// child's k·A are saved.
  bool gives_way(Number number) const {
    const Hierarchy::Node &child = tree_[number], &parent = tree_[child.parent];
    if (child.is_leaf() || parent.arity - 1 + child.arity > most_children_) return false;
    return area<double>(parent.box) * (child.arity - 1) < area<double>(child.box) * child.arity;
  }

  Hierarchy& tree_;
  unsigned most_children_;
  std::vector<double> after_;  // the surfaces of the boxes behind each cut
};

}  // namespace

Hierarchy::Number top_down(Hierarchy& tree, std::span<Hierarchy::Number> leaves, unsigned most_children) {
  return TopDown(tree, most_children).join(leaves, 0);
}

}  // namespace durero::accel
