#pragma once
/// The stack of a bundle's traversal of the wide hierarchy.

#include <array>
#include <bit>
#include <cstdint>

#include "durero/accel/wide/wide_node.hpp"

namespace durero::accel {

/// A child on the stack: its parent, its place there, and a lower bound of the rays' entry into its box.
struct StackEntry {
  double entry;         ///< not less than 0
  std::uint32_t node;   ///< the parent
  std::uint32_t place;  ///< among the parent's children
};

/// The children that a bundle has still to visit, the next one on top.
class TraversalStack {
 public:
  /// @{ The operations of a stack.
  bool empty() const { return size_ == 0; }
  StackEntry pop() { return waiting_[--size_]; }
  /// @}
  /// Pushes the children of a node in `met`, the nearest on top.
  void push(std::uint32_t node, unsigned met, const WideNode::Entries& entries) {
    const std::size_t begin = size_;
    for (; met != 0; met &= met - 1) {
      const auto place = static_cast<std::uint32_t>(std::countr_zero(met));
      std::size_t at = size_++;
      for (; at > begin && waiting_[at - 1].entry < entries[place]; --at) waiting_[at] = waiting_[at - 1];
      waiting_[at] = {entries[place], node, place};
    }
  }

 private:
  std::array<StackEntry, most_waiting> waiting_;  // only the first size_ are set
  std::size_t size_ = 0;
};

}  // namespace durero::accel
