#pragma once
/// Many rays through the wide hierarchy. Those that stay close together walk it as bundles (wide_bundles.hpp). The
/// others walk in streams, an octant of directions in each, or alone, several in turns, so that the memory which one
/// waits for comes while the others walk.

#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "durero/accel/wide_bundles.hpp"
#include "durero/accel/wide_leaves.hpp"
#include "durero/accel/wide_order.hpp"
#include "durero/accel/wide_stream.hpp"
#include "durero/accel/wide_walker.hpp"
#include "durero/trace/finding.hpp"

namespace durero::accel {

/// PairCandidates::pairs over a tree that has nodes(), leaves() and spacing().
template <class Tree, class Limit, class Take, class Flush>
class WideWalk {
 public:
  /// All of these must outlive it. Preconditions: the tree has a node; there is a ray.
  WideWalk(const Tree& tree, std::span<const trace::Ray> rays, Limit& limit, Take& take, Flush& flush)
      : nodes_(tree.nodes()),
        leaves_(tree.leaves()),
        waits_for_leaves_(nodes_.size_bytes() > WideLeaves::nearby),
        spacing_(tree.spacing()),
        rays_(rays),
        limit_(limit),
        take_(take),
        bundles_(tree, rays, limit, take, flush) {}

  /// Every ray.
  void all() {
    if constexpr (Bundles::takes_any) {
      add_in_order();
    } else {
      const bool some_company = bundles_.some_company();
      for (std::uint32_t number = 0; number < rays_.size(); ++number) {
        const double limit = limit_(number);
        if (!(limit > 0)) continue;
        if (some_company) {
          bundles_.add(number, limit);
        } else {
          alone_.push_back(number);
        }
      }
    }
    bundles_.finish(alone_);
    // In a large tree too few of the rays come to the same node, and none is asked of memory ahead.
    if (alone_.size() < least_stream || nodes_.size_bytes() > WideLeaves::nearby) return walk_alone();
    walk_streams();
  }

 private:
  using Bundles = WideBundles<Tree, Limit, Take, Flush>;

  static constexpr std::size_t least_stream = 64;   // rays alone that walk as streams
  static constexpr std::size_t at_a_time = 16;      // rays alone
  static constexpr std::size_t in_cache = 1 << 14;  // bytes of nodes that need no waiting for

  /// In a large tree those that find company follow each other.
  void add_in_order() {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(rays_.size());
    for (std::uint32_t number = 0; number < rays_.size(); ++number)
      if (limit_(number) > 0) numbers.push_back(number);
    sort_segments(WideKeys(nodes_[0], spacing_), rays_, numbers);
    constexpr std::size_t ahead = 16;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (i + ahead < numbers.size()) trace::ask_for(rays_[numbers[i + ahead]]);
      bundles_.add(numbers[i], limit_(numbers[i]));
    }
  }

  /// A walker, and the number of its ray.
  struct Walking {
    explicit Walking(const trace::Ray& ray) : walker(ray) {}
    WideWalker walker;
    std::uint32_t number = 0;
    bool arrived = false;  // at an element, which memory was asked for
  };

  static std::size_t octant_of(const glm::dvec3& v) {
    return static_cast<std::size_t>(std::signbit(v.x) + 2 * std::signbit(v.y) + 4 * std::signbit(v.z));
  }

  /// The rays alone, those of each octant together.
  void walk_streams() {
    std::array<std::size_t, 9> begin{};  // of each octant, and the end of the last
    for (const std::uint32_t number : alone_) ++begin[octant_of(rays_[number].v) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::array<std::size_t, 9> next = begin;
    std::vector<std::uint32_t> numbers(alone_.size());
    for (const std::uint32_t number : alone_) numbers[next[octant_of(rays_[number].v)]++] = number;
    std::vector<WideStreamRay> streams;
    streams.reserve(numbers.size());
    for (const std::uint32_t number : numbers) streams.push_back({Beam(rays_[number]), trace::no_limit, number});
    WideStream stream(nodes_, limit_, take_);
    for (std::size_t octant = 0; octant < 8; ++octant)
      stream.walk(std::span(streams).subspan(begin[octant], begin[octant + 1] - begin[octant]));
  }

  /// The rays alone: one by one where the nodes fit the cache, and else several in turns.
  void walk_alone() {
    const bool few = nodes_.size_bytes() <= in_cache;
    std::vector<Walking> walking;
    std::size_t next = 0;
    const auto start = [&](Walking& one) {
      one.number = alone_[next++];
      one.walker.restart(rays_[one.number]);
    };
    walking.reserve(few ? 1 : at_a_time);
    while (next < alone_.size() && walking.size() < (few ? 1 : at_a_time))
      start(walking.emplace_back(rays_[alone_[next]]));
    std::array<std::uint32_t, at_a_time> active{};
    std::size_t count = walking.size();
    for (std::uint32_t i = 0; i < count; ++i) active[i] = i;
    const auto pace = few ? WideWalker::Pace::steady : WideWalker::Pace::by_nodes;
    while (count > 0) {
      for (std::size_t i = 0; i < count;) {
        Walking& one = walking[active[i]];
        if (goes_on(one, pace)) {
          ++i;
        } else if (next < alone_.size()) {
          start(one);
          ++i;
        } else {
          active[i] = active[--count];
        }
      }
    }
  }

  /// Goes on to the next node, and in a large tree to the next element, of which memory is asked for before another's
  /// turn. Whether there is more.
  bool goes_on(Walking& one, WideWalker::Pace pace) {
    if (one.arrived) take_(one.number, one.walker.element);
    one.arrived = false;
    for (;;) {
      switch (one.walker.advance(nodes_.data(), limit_(one.number), pace)) {
        case WideWalker::Next::element:
          if (waits_for_leaves_) {
            accel::ask_for(nodes_, leaves_,
                           {one.walker.element.index, one.walker.element.tipo, WideChild::Kind::element});
            return one.arrived = true;
          }
          take_(one.number, one.walker.element);
          break;
        case WideWalker::Next::node:
          return true;
        case WideWalker::Next::end:
          return false;
      }
    }
  }

  std::span<const WideNode> nodes_;
  const WideLeaves& leaves_;
  bool waits_for_leaves_;
  double spacing_;
  std::span<const trace::Ray> rays_;
  Limit& limit_;
  Take& take_;
  Bundles bundles_;
  std::vector<std::uint32_t> alone_;
};

}  // namespace durero::accel
