#pragma once
/// Many rays through the wide hierarchy. Consecutive rays that stay close together walk it as one bundle, and each of
/// them is tested against the box of an element that the bundle reaches. The others walk in streams, an octant of
/// directions in each, or alone, several in turns, so that the memory which one waits for comes while the others walk.
/// Which rays are bundled costs time only: the tests of bundles pass over nothing that those of single rays do not
/// (wide_node.hpp).

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/accel/wide_leaves.hpp"
#include "durero/accel/wide_stream.hpp"
#include "durero/accel/wide_walker.hpp"
#include "durero/trace/finding.hpp"
#include "durero/trace/picked.hpp"

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

/// PairCandidates::pairs over a tree that has nodes(), leaves() and spacing().
template <class Tree, class Limit, class Take, class Flush>
class WideWalk {
 public:
  /// All of these must outlive it. Preconditions: the tree has a node; there is a ray.
  WideWalk(const Tree& tree, std::span<const trace::Ray> rays, Limit& limit, Take& take, Flush& flush)
      : nodes_(tree.nodes()),
        leaves_(tree.leaves()),
        waits_for_leaves_(nodes_.size_bytes() > nearby),
        narrow_(widest * tree.spacing()),
        rays_(rays),
        limit_(limit),
        take_(take),
        flush_(flush) {
    const std::size_t root = 0;
    for (int i = 0; i < 3; ++i) {
      const auto& low = nodes_[root].planes[static_cast<std::size_t>(i)];
      const auto& high = nodes_[root].planes[static_cast<std::size_t>(i) + 3];
      all_.low[i] = static_cast<double>(*std::ranges::min_element(low));
      all_.high[i] = static_cast<double>(*std::ranges::max_element(high));
    }
  }

  /// Every ray.
  void all() {
    for (std::uint32_t number = 0; number < rays_.size(); ++number) {
      const double limit = limit_(number);
      if (!(limit > 0)) continue;
      numbers_[count_] = number;
      bundle_.set(count_++, rays_[number], limit);
      if (count_ == WideBundle::size) release();
    }
    release();
    // In a large tree too few of the rays come to the same node, and none is asked of memory ahead.
    if (alone_.size() < least_stream || nodes_.size_bytes() > nearby) return walk_alone();
    walk_streams();
  }

 private:
  static constexpr double widest = 2;               // of a bundle, in spacings of the elements
  static constexpr std::size_t least = 6;           // rays of a bundle that is worth it
  static constexpr std::size_t least_stream = 64;   // rays alone that walk as streams
  static constexpr std::size_t at_a_time = 16;      // rays alone
  static constexpr std::size_t in_cache = 1 << 14;  // bytes of nodes that need no waiting for,
  static constexpr std::size_t nearby = 1 << 18;    // and of those whose elements need none
  static constexpr std::size_t patience = 32;       // pairs, until the limits are brought up to date
  static constexpr int dense_from = 2;              // bits of an eight

  /// The rays that are there go their ways. The last eight is filled up by rays that take no part.
  void release() {
    if (count_ == 0) return;
    const std::size_t places = (count_ + WideBundle::eight - 1) / WideBundle::eight * WideBundle::eight;
    for (std::size_t place = count_; place < places; ++place) bundle_.set(place, rays_[numbers_[count_ - 1]], -1);
    invert(bundle_, places);
    part(0, places);
    count_ = 0;
  }

  /// Those at begin … end together where they stay narrow, and else each half of them; few are alone.
  void part(std::size_t begin, std::size_t end) {
    const std::size_t last = std::min(end, count_);
    if (last - begin >= least && gather(bundle_, begin, end) && narrow()) return walk_bundle();
    if (end - begin > WideBundle::eight) {
      const std::size_t eights = (end - begin) / WideBundle::eight, middle = begin + eights / 2 * WideBundle::eight;
      part(begin, middle);
      return part(middle, end);
    }
    for (std::size_t place = begin; place < last; ++place) alone_.push_back(numbers_[place]);
  }

  /// As far as the box of the scene, or to the limit.
  bool narrow() const {
    const Beam first(rays_[numbers_[bundle_.begin]]);
    const double reach = stretch(all_, first, bundle_.limit[bundle_.begin]).exit;
    bool narrow = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double apart = bundle_.p_high[axis] - bundle_.p_low[axis];
      narrow &= apart + std::max(reach, 0.0) * (bundle_.v_high[axis] - bundle_.v_low[axis]) <= narrow_;
    }
    return narrow;
  }

  void walk_bundle() {
    std::uint64_t taken = 0;
    std::size_t pending = 0;
    double limit = farthest(bundle_);
    WideStack waiting;
    open(waiting, 0, limit);
    while (!waiting.empty()) {
      const auto [entry, node, place] = waiting.pop();
      if (entry > latest_entry(limit)) continue;
      const WideChild& child = nodes_[node].children[place];
      if (child.kind == WideChild::Kind::node) {
        open(waiting, child.index, limit);
        continue;
      }
      const std::uint64_t meeting = met_by(nodes_[node], place, bundle_);
      if (meeting == 0) continue;
      if constexpr (takes_many) {
        if (dense(meeting)) {
          const std::uint64_t changed = take_(bundle_.rays, numbers_, meeting, child.element());
          if (changed == 0) continue;
          bring_up_to_date(changed);
          limit = farthest(bundle_);
          continue;
        }
      }
      for (std::uint64_t left = meeting; left != 0; left &= left - 1)
        take_(numbers_[static_cast<std::size_t>(std::countr_zero(left))], child.element());
      taken |= meeting;
      pending += static_cast<std::size_t>(std::popcount(meeting));
      if (pending < patience) continue;
      flush_();
      bring_up_to_date(taken);
      taken = 0;
      pending = 0;
      limit = farthest(bundle_);
    }
  }

  /// What is taken of rays in columns may be told together: take(columns, numbers, which, element) answers a bit for
  /// each ray whose limit has changed.
  using Numbers = std::array<std::uint32_t, WideBundle::size>;
  static constexpr bool takes_many =
      requires(Take& take, const trace::RayColumns& rays, const Numbers& numbers, scene::ElementRef element) {
        { take(rays, numbers, std::uint64_t{}, element) } -> std::same_as<std::uint64_t>;
      };

  /// So many bits in each eight that has some that their rays are better tested where they stand.
  static bool dense(std::uint64_t which) {
    std::uint64_t eights = which | which >> 4;
    eights |= eights >> 2;
    eights = (eights | eights >> 1) & 0x0101010101010101;
    return std::popcount(which) >= dense_from * std::popcount(eights);
  }

  /// The limits of those that have a bit.
  void bring_up_to_date(std::uint64_t which) {
    for (; which != 0; which &= which - 1) {
      const auto place = static_cast<std::size_t>(std::countr_zero(which));
      const double limit = limit_(numbers_[place]);
      bundle_.limit[place] = limit > 0 ? limit : -1;
    }
  }

  /// A walker, and the number of its ray.
  struct Walking {
    explicit Walking(const trace::Ray& ray) : walker(ray) {}
    WideWalker walker;
    std::uint32_t number = 0;
    bool arrived = false;  // at an element, which memory was asked for
  };

  /// The rays alone, those of each octant together.
  void walk_streams() {
    std::array<std::vector<WideStreamRay>, 8> octants;
    for (const std::uint32_t number : alone_) {
      const Beam beam(rays_[number]);
      const int octant =
          std::signbit(beam.inverse.x) + 2 * std::signbit(beam.inverse.y) + 4 * std::signbit(beam.inverse.z);
      octants[static_cast<std::size_t>(octant)].push_back({beam, trace::no_limit, number});
    }
    WideStream stream(nodes_, limit_, take_);
    for (std::vector<WideStreamRay>& octant : octants) stream.walk(octant);
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
            ask_for({one.walker.element.index, one.walker.element.tipo, WideChild::Kind::element});
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

  void open(WideStack& waiting, std::uint32_t node, double limit) const {
    WideNode::Entries entries;
    const unsigned bits = met(nodes_[node], bundle_, limit, entries);
    if (waits_for_leaves_)
      for (unsigned left = bits; left != 0; left &= left - 1)
        ask_for(nodes_[node].children[static_cast<std::size_t>(std::countr_zero(left))]);
    waiting.push(node, bits, entries);
  }

  /// Asks memory for what a child is.
  void ask_for(const WideChild& child) const {
    if (child.kind == WideChild::Kind::node) return trace::ask_for(nodes_[child.index]);
    trace::ask_for(leaves_.row(child.element()));
  }

  std::span<const WideNode> nodes_;
  const WideLeaves& leaves_;
  bool waits_for_leaves_;
  double narrow_;
  std::span<const trace::Ray> rays_;
  Limit& limit_;
  Take& take_;
  Flush& flush_;
  surface::Box all_{};
  WideBundle bundle_;
  Numbers numbers_;        // of the rays in it
  std::size_t count_ = 0;  // how many
  std::vector<std::uint32_t> alone_;
};

}  // namespace durero::accel
