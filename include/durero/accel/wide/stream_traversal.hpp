#pragma once
/// Stream traversal of the wide hierarchy, for rays whose directions lie in one octant. The traversal opens a node once
/// for all rays that reach it, and tests each ray against the node's eight boxes in lanes. The rays need not be close
/// together. The tests of different rays are independent of each other, so the processor overlaps them.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/accel/wide/leaf_columns.hpp"
#include "durero/accel/wide/wide_node.hpp"
#include "durero/trace/finding.hpp"

namespace durero::accel {

/// A ray of a stream, in one cache line.
struct alignas(64) StreamRay {
  Beam beam;             ///< the ray
  double limit;          ///< the limit (tmax)
  std::uint32_t number;  ///< the caller's number of the ray
};

/// The pairs of a ray and a child whose box the ray meets, in columns.
struct StreamPairs {
  std::vector<double> entries;       ///< the entry parameter, not less than 0
  std::vector<std::uint64_t> whose;  ///< the ray, and 2³² times the child's place
  std::size_t size = 0;              ///< the number of pairs
  /// @{ For each child: the number of rays that meet its box, and the least of their entry parameters, ∞ where there is
  /// none.
  std::array<std::uint64_t, WideNode::width> count{};
  std::array<double, WideNode::width> soonest{};
  /// @}

  static std::size_t place(std::uint64_t whose) { return whose >> 32; }               ///< of the child
  static auto ray(std::uint64_t whose) { return static_cast<std::uint32_t>(whose); }  ///< its place among the rays
};

/// Finds the boxes of a node that the rays in `some` meet at 0 < t ≤ their limits, by the test of `stretch`.
/// Precondition: the directions' components along an axis have one sign.
void meet(const WideNode& node, std::span<const StreamRay> rays, std::span<const std::uint32_t> some, StreamPairs& met);

/// A traversal of streams; limit(number) and take(number, element) are those of PairCandidates::pairs.
template <class Limit, class Visitor>
class StreamTraversal {
 public:
  /// The traversal keeps references to its arguments, which must outlive it.
  StreamTraversal(std::span<const WideNode> nodes, trace::TriangleBlocks blocks, Limit& limit, Visitor& take)
      : nodes_(nodes), blocks_(blocks), limit_(limit), take_(take) {}

  /// Traverses the tree from the root with every ray. Preconditions: the directions lie in one octant; limits are not
  /// less than 0.
  void walk(std::span<StreamRay> rays) {
    rays_ = rays;
    waiting_.resize(std::max(waiting_.size(), waiting_size_ = rays.size()));
    for (std::uint32_t i = 0; i < rays.size(); ++i) waiting_[i] = {0, i};
    children_.assign(1, {WideChild{0, {}, WideChild::Kind::node}, 0});
    while (!children_.empty()) {
      const auto [child, begin] = children_.back();
      children_.pop_back();
      arrive(begin);
      if (here_.empty()) continue;
      if (child.kind == WideChild::Kind::element) {
        for (const std::uint32_t ray : here_) take_(rays_[ray].number, child.element());
      } else if (child.kind == WideChild::Kind::block) {
        for (const std::uint32_t ray : here_) take_block(take_, rays_[ray].number, blocks_, child.index);
      } else {
        open(nodes_[child.index]);
      }
    }
  }

 private:
  /// A ray that waits at a child, and its entry parameter into the child's box.
  struct Waiting {
    double entry;
    std::uint32_t ray;
  };
  /// A child on the stack. Its waiting rays are those from `begin` to the end of waiting_, once the child is on top.
  struct Child {
    WideChild child;
    std::size_t begin;
  };

  /// Pops the rays that wait from `begin` on into here_, but for those whose limits have fallen below their entry.
  void arrive(std::size_t begin) {
    here_.resize(waiting_size_ - begin);
    std::size_t come = 0;
    for (const auto [entry, ray] : std::span(waiting_).subspan(begin, here_.size())) {
      const double limit = rays_[ray].limit = limit_(rays_[ray].number);
      here_[come] = ray;
      come += static_cast<std::size_t>((limit > 0) & (entry <= latest_entry(limit)));
    }
    here_.resize(come);
    waiting_size_ = begin;
  }

  /// Pushes the children of a node that some ray in here_ meets, with their rays; the child with the least entry is on
  /// top.
  void open(const WideNode& node) {
    meet(node, rays_, here_, met_);
    std::array<std::uint8_t, WideNode::width> order{};
    std::size_t children = 0;
    for (std::uint8_t place = 0; place < WideNode::width; ++place) {
      if (met_.count[place] == 0) continue;
      std::size_t at = children++;
      for (; at > 0 && met_.soonest[order[at - 1]] < met_.soonest[place]; --at) order[at] = order[at - 1];
      order[at] = place;
    }
    std::array<std::size_t, WideNode::width> end{};  // the end of the rays written for each child
    for (std::size_t i = 0; i < children; ++i) {
      children_.push_back({node.children[order[i]], end[order[i]] = waiting_size_});
      waiting_size_ += met_.count[order[i]];
    }
    if (waiting_.size() < waiting_size_) waiting_.resize(2 * waiting_size_);
    for (std::size_t i = 0; i < met_.size; ++i)
      waiting_[end[StreamPairs::place(met_.whose[i])]++] = {met_.entries[i], StreamPairs::ray(met_.whose[i])};
  }

  std::span<const WideNode> nodes_;
  trace::TriangleBlocks blocks_;
  Limit& limit_;
  Visitor& take_;
  std::span<StreamRay> rays_;
  std::vector<Child> children_;   // the stack of children
  std::vector<Waiting> waiting_;  // their rays, in the order of the stack: only the first waiting_size_ are set
  std::size_t waiting_size_ = 0;
  std::vector<std::uint32_t> here_;  // the rays at the child that is visited
  StreamPairs met_;
};

}  // namespace durero::accel
