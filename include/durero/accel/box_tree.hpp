#pragma once
/// A hierarchy of boxes alone, for elements whose points another layer knows. Its boxes are tested as those of the BVH
/// are (accel/slab.hpp), so that a ray with a point in a box up to the limit finds it.

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <span>

#include "durero/accel/hierarchy.hpp"
#include "durero/accel/slab.hpp"
#include "durero/trace/ray.hpp"

namespace durero::accel {

/// A tree over boxes, which are numbered in the order given.
class BoxTree {
 public:
  BoxTree() = default;  ///< of no box
  /// Of these boxes. Precondition: their planes are finite and of magnitude 2¹⁰²² or less.
  explicit BoxTree(std::span<const surface::Box> boxes);

  /// visit(i) for each box i that the ray may have a point of at 0 < t ≤ limit(), until it answers true; nearer boxes
  /// come first, more or less. Whether it did. Precondition: the ray is ordinary.
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit) const {
    if (tree_.empty()) return false;
    const Beam beam(ray);
    boost::container::small_vector<Reached, 64> left;
    const auto reach = [&](Hierarchy::Number number) {
      const BoxInterval within = stretch(tree_[number].box, beam, limit());
      if (within.meets()) left.push_back({number, within.entry});
      return false;
    };
    reach(tree_.root());
    while (!left.empty()) {
      const Reached nearest = left.back();
      left.pop_back();
      if (!BoxInterval{nearest.entry, limit()}.meets()) continue;
      const Hierarchy::Node& node = tree_[nearest.node];
      if (node.is_leaf()) {
        if (visit(node.element.index)) return true;
        continue;
      }
      const std::size_t before = left.size();
      tree_.any_child(nearest.node, reach);
      std::sort(left.begin() + before, left.end(),
                [](const Reached& a, const Reached& b) { return a.entry > b.entry; });
    }
    return false;
  }

 private:
  struct Reached {
    Hierarchy::Number node;
    double entry;
  };

  Hierarchy tree_;
};

}  // namespace durero::accel
