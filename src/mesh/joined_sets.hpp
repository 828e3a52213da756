#pragma once
/// Sets that are joined two at a time, each known by its least member.

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace durero::mesh {

/// Of the numbers below a count, each of which is a set at first.
class JoinedSets {
 public:
  explicit JoinedSets(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0U); }

  /// The least member of the set of n.
  std::uint32_t least(std::uint32_t n) {
    while (parents_[n] != n) n = parents_[n] = parents_[parents_[n]];
    return n;
  }
  /// Makes one set of those of a and b.
  void join(std::uint32_t a, std::uint32_t b) {
    a = least(a), b = least(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parents_;
};

}  // namespace durero::mesh
