#pragma once
/// Single-ray traversal of the wide hierarchy, nearest box first. Several rays can open their nodes side by side.

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "durero/accel/wide/leaf_columns.hpp"
#include "durero/accel/wide/wide_node.hpp"

namespace durero::accel {

/// A traversal by one ray, and its stack. It can be left and resumed.
struct SingleRayTraversal {
  /// A traversal has reached an element to test, a node to open, a block of triangles, or its end.
  enum class Next : std::uint8_t { element, node, block, end };

  static constexpr std::size_t room = most_waiting + WideNode::width;  ///< of the stack: a store fills whole lanes

  /// Starts at the root. Precondition: the ray is ordinary.
  explicit SingleRayTraversal(const trace::Ray& ray) : beam(ray) { restart(ray); }
  /// Restarts at the root with another ray. Precondition: the ray is ordinary.
  void restart(const trace::Ray& ray);

  /// Pops the next child whose entry is not beyond the limit `greatest`, which later box tests use too. Preconditions:
  /// the limit is not less than 0; the node that the traversal reached last, if any, was opened.
  Next next(double greatest) {
    limit = greatest;
    const double latest = latest_entry(limit);
    while (size > 0) {
      if (entries[--size] > latest) {
        ++late;
        continue;
      }
      const auto child = std::bit_cast<WideChild>(children[size]);
      if (child.kind == WideChild::Kind::element) {
        element = child.element();
        return Next::element;
      }
      node = child.index;
      return child.kind == WideChild::Kind::node ? Next::node : Next::block;
    }
    return Next::end;
  }
  /// Goes on to the next element or the end, and opens the nodes and blocks on the way. Precondition: that of next.
  Next advance(const WideNode* nodes, trace::TriangleBlocks blocks, double greatest);

  Beam beam;                    ///< the ray
  double limit = 0;             ///< the limit (tmax)
  scene::ElementRef element{};  ///< the last element that was reached
  std::uint32_t node = 0;       ///< the last node or block that was reached
  std::uint32_t size = 0;       ///< of the stack
  std::uint32_t sorted = 0;     ///< size of the stack before the last node's children, which are unordered until then
  /// @{ Counters, summed over all rays since construction.
  std::uint32_t nodes = 0;  ///< nodes opened
  std::uint32_t met = 0;    ///< boxes met
  std::uint32_t late = 0;   ///< children that the limit pruned from the stack
  /// @}
  std::array<double, room> entries;          ///< of the stack's children
  std::array<std::uint64_t, room> children;  ///< the stack, as the bytes of WideChild
};

/// Opens the nodes that some traversals have reached. The boxes of all are tested first, without a branch, so that one
/// ray's tests need not wait for another's; the children that each ray meets are sorted then.
void open(const WideNode* nodes, std::span<SingleRayTraversal* const> walkers);

}  // namespace durero::accel
