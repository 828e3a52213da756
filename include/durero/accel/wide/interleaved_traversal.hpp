#pragma once
/// Interleaved traversal of the wide hierarchy by single rays. In each turn the rays that have reached a node open it
/// side by side (single_ray_traversal.hpp), and the prefetches of one ray complete while the others go on.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/accel/wide/leaf_columns.hpp"
#include "durero/accel/wide/single_ray_traversal.hpp"

namespace durero::accel {

/// A traversal of several rays in turns; limit(number) and take(number, element) are those of PairCandidates::pairs.
template <class Limit, class Visitor>
class InterleavedTraversal {
 public:
  /// The traversal keeps references to its arguments, which must outlive it. Precondition: there is a node.
  InterleavedTraversal(std::span<const WideNode> nodes, const LeafColumns& leaves, std::span<const trace::Ray> rays,
                       Limit& limit, Visitor& take)
      : nodes_(nodes), blocks_(leaves.blocks()), rows_(leaves.rows()), rays_(rays), limit_(limit), take_(take) {}

  /// Traverses the tree with the rays of these numbers.
  void walk(std::span<const std::uint32_t> numbers) {
    coming_ = numbers;
    std::vector<Walking> walking;
    walking.reserve(std::min(numbers.size(), at_a_time));
    std::array<Walking*, at_a_time> active{};
    std::size_t count = 0;
    for (; count < at_a_time && !coming_.empty(); ++count) {
      const std::uint32_t number = next_number();
      active[count] = &walking.emplace_back(rays_[number], number);
    }
    while (count > 0) {
      std::array<SingleRayTraversal*, at_a_time> at_nodes{};
      std::size_t nodes = 0;
      for (std::size_t i = 0; i < count;) {
        Walking& one = *active[i];
        if (goes_on(one)) {
          if (one.at == SingleRayTraversal::Next::node) at_nodes[nodes++] = &one.walker;
          ++i;
        } else {
          active[i] = active[--count];
        }
      }
      open(nodes_.data(), std::span(at_nodes).first(nodes));
    }
  }

 private:
  static constexpr std::size_t at_a_time = 24;  // rays in flight

  /// A ray's traversal, and the ray's number.
  struct Walking {
    Walking(const trace::Ray& ray, std::uint32_t number_of_it) : walker(ray), number(number_of_it) {}
    SingleRayTraversal walker;
    std::uint32_t number;
    SingleRayTraversal::Next at = SingleRayTraversal::Next::node;  // an element or a block was prefetched
  };

  /// Takes the next ray that has not started.
  std::uint32_t next_number() {
    const std::uint32_t number = coming_.front();
    coming_ = coming_.subspan(1);
    return number;
  }

  /// Tests the element that the traversal has reached, and goes on to the next node or element, which it prefetches
  /// before the other rays' turns. A traversal that ends restarts with another ray; false where none is left.
  bool goes_on(Walking& one) {
    if (one.at == SingleRayTraversal::Next::block) take_block(take_, one.number, blocks_, one.walker.node);
    if (one.at == SingleRayTraversal::Next::element) take_(one.number, one.walker.element);
    for (;;) {
      switch (one.at = one.walker.next(limit_(one.number))) {
        case SingleRayTraversal::Next::element:
          rows_.ask_for(one.walker.element);
          return true;
        case SingleRayTraversal::Next::block:
          blocks_[one.walker.node].ask();
          return true;
        case SingleRayTraversal::Next::node:
          trace::ask_for(nodes_[one.walker.node]);
          return true;
        case SingleRayTraversal::Next::end:
          if (coming_.empty()) return false;
          one.number = next_number();
          one.walker.restart(rays_[one.number]);
      }
    }
  }

  std::span<const WideNode> nodes_;
  trace::TriangleBlocks blocks_;
  LeafColumns::Rows rows_;
  std::span<const trace::Ray> rays_;
  Limit& limit_;
  Visitor& take_;
  std::span<const std::uint32_t> coming_;  // rays that have not started
};

}  // namespace durero::accel
