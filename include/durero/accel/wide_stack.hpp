#pragma once
/// What waits while a bundle of rays walks the wide hierarchy.

#include <array>
#include <bit>
#include <cstdint>

#include "durero/accel/wide_node.hpp"

namespace durero::accel {

/// The child at a place of a node, and where the first ray enters its box.
struct WideWaiting {
  double entry;         ///< not less than 0
  std::uint32_t node;   ///< the parent
  std::uint32_t place;  ///< among its children
};

/// The children that wait while a bundle walks, the next one last.
class WideStack {
 public:
  /// @{ As of a vector.
  bool empty() const { return size_ == 0; }
  WideWaiting pop() { return waiting_[--size_]; }
  /// @}
  /// Adds the children of a node that have a bit in `met`, the nearest last.
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
  std::array<WideWaiting, most_waiting> waiting_;  // only the first size_ mean anything
  std::size_t size_ = 0;
};

}  // namespace durero::accel
