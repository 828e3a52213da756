#pragma once
/// Rays whose directions lie in one octant on their way through the wide hierarchy together: a node is opened once for
/// all of them that come to it, and each is tested against its eight boxes in lanes. They need not be close together;
/// no ray waits for another's numbers, so that the tests of many overlap.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/accel/wide_node.hpp"
#include "durero/trace/finding.hpp"

namespace durero::accel {

/// A ray of a stream. A line of the cache.
struct alignas(64) WideStreamRay {
  Beam beam;             ///< the ray
  double limit;          ///< beyond which nothing of it matters
  std::uint32_t number;  ///< the caller's name of it
};

/// Boxes that rays meet, in columns: of each the ray, the place among the children, and the parameter at which it is
/// entered.
struct WideMet {
  std::vector<double> entries;       ///< not less than 0
  std::vector<std::uint64_t> whose;  ///< the ray, and 2³² times the place
  std::size_t size = 0;              ///< how many
  /// @{ Of each child: how many rays meet its box, and where the first of them enters it; ∞ for none.
  std::array<std::uint64_t, WideNode::width> count{};
  std::array<double, WideNode::width> soonest{};
  /// @}

  static std::size_t place(std::uint64_t whose) { return whose >> 32; }               ///< among the children
  static auto ray(std::uint64_t whose) { return static_cast<std::uint32_t>(whose); }  ///< its place among the rays
};

/// Which boxes of a node some of the rays meet at 0 < t ≤ their limits, as `stretch` finds it. Precondition: the
/// components of all directions have the same signs.
void meet(const WideNode& node, std::span<const WideStreamRay> rays, std::span<const std::uint32_t> some, WideMet& met);

/// Walks of streams. limit(number) and take(number, element) as in PairCandidates::pairs.
template <class Limit, class Take>
class WideStream {
 public:
  /// All of these must outlive it.
  WideStream(std::span<const WideNode> nodes, Limit& limit, Take& take) : nodes_(nodes), limit_(limit), take_(take) {}

  /// Every ray from the root on. Preconditions: as of `meet`; the limits are not less than 0.
  void walk(std::span<WideStreamRay> rays) {
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
      } else {
        open(nodes_[child.index]);
      }
    }
  }

 private:
  /// A ray that waits at a child, whose box it enters there.
  struct Waiting {
    double entry;
    std::uint32_t ray;
  };
  /// A child, and where those that wait at it begin: they are the last.
  struct Child {
    WideChild child;
    std::size_t begin;
  };

  /// Those that wait from a place on come here, but for those whose limits have fallen below their entry meanwhile.
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

  /// Those that are here go on to the children that they meet; where the first of them comes soonest is next.
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
    std::array<std::size_t, WideNode::width> end{};  // of those that wait at each, once all of them do
    for (std::size_t i = 0; i < children; ++i) {
      children_.push_back({node.children[order[i]], end[order[i]] = waiting_size_});
      waiting_size_ += met_.count[order[i]];
    }
    if (waiting_.size() < waiting_size_) waiting_.resize(2 * waiting_size_);
    for (std::size_t i = 0; i < met_.size; ++i)
      waiting_[end[WideMet::place(met_.whose[i])]++] = {met_.entries[i], WideMet::ray(met_.whose[i])};
  }

  std::span<const WideNode> nodes_;
  Limit& limit_;
  Take& take_;
  std::span<WideStreamRay> rays_;
  std::vector<Child> children_;   // to be visited, the next one last
  std::vector<Waiting> waiting_;  // at each of them, in their order: the first waiting_size_
  std::size_t waiting_size_ = 0;
  std::vector<std::uint32_t> here_;  // at the child that is being visited
  WideMet met_;
};

}  // namespace durero::accel
