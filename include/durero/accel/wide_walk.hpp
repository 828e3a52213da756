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
#include <cstdint>
#include <glm/common.hpp>
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
        flush_(flush),
        first_(rays.front()) {
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
      if (!(limit_(number) > 0)) continue;
      const Beam beam(rays_[number]);
      if (!joins(rays_[number], beam)) {
        release();
        if (!joins(rays_[number], beam)) {
          alone_.push_back(number);
          continue;
        }
      }
      numbers_[bundle_.count] = number;
      bundle_.push(beam);
    }
    release();
    // In a large tree too few of the rays come to the same node, and none is asked of memory ahead.
    if (alone_.size() < least_stream || nodes_.size_bytes() > nearby) return walk_alone();
    walk_streams();
  }

 private:
  static constexpr double widest = 2;               // of a bundle, in spacings of the elements
  static constexpr double unknown = -1;             // no reach
  static constexpr std::size_t least = 6;           // rays of a bundle that is worth it
  static constexpr std::size_t least_stream = 64;   // rays alone that walk as streams
  static constexpr std::size_t at_a_time = 16;      // rays alone
  static constexpr std::size_t in_cache = 1 << 14;  // bytes of nodes that need no waiting for,
  static constexpr std::size_t nearby = 1 << 18;    // and of those whose elements need none
  static constexpr std::size_t patience = 32;       // pairs, until the limits are brought up to date

  /// The bundle takes the ray, and stays narrow as far as the box of the scene.
  bool joins(const trace::Ray& ray, const Beam& beam) {
    if (bundle_.count == WideBundle::size || !bundle_.takes(beam)) return false;
    if (bundle_.count == 0) {
      first_ = beam;
      reach_ = unknown;
      v_low_ = v_high_ = ray.v;
      return true;
    }
    glm::dvec3 apart;
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      apart[i] = std::max(bundle_.p_high[axis], ray.p[i]) - std::min(bundle_.p_low[axis], ray.p[i]);
    }
    if (!within(apart)) return false;
    if (reach_ == unknown) reach_ = stretch(all_, first_, trace::no_limit).exit;
    const glm::dvec3 v_low = glm::min(v_low_, ray.v), v_high = glm::max(v_high_, ray.v);
    if (!within(apart + reach_ * (v_high - v_low))) return false;
    v_low_ = v_low, v_high_ = v_high;
    return true;
  }
  bool within(const glm::dvec3& apart) const {
    return (apart.x <= narrow_) & (apart.y <= narrow_) & (apart.z <= narrow_);
  }

  void release() {
    if (bundle_.count >= least) {
      walk_bundle();
    } else {
      for (std::size_t i = 0; i < bundle_.count; ++i) alone_.push_back(numbers_[i]);
    }
    bundle_.count = 0;
  }

  void walk_bundle() {
    for (std::size_t i = 0; i < bundle_.count; ++i) bundle_.limit[i] = limit_of(i);
    std::uint64_t taken = 0;
    std::size_t pending = 0;
    double limit = farthest();
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
      for (std::uint64_t left = meeting; left != 0; left &= left - 1)
        take_(numbers_[static_cast<std::size_t>(std::countr_zero(left))], child.element());
      taken |= meeting;
      pending += static_cast<std::size_t>(std::popcount(meeting));
      if (pending < patience) continue;
      flush_();
      for (; taken != 0; taken &= taken - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(taken));
        bundle_.limit[i] = limit_of(i);
      }
      pending = 0;
      limit = farthest();
    }
  }

  double limit_of(std::size_t i) const {
    const double limit = limit_(numbers_[i]);
    return limit > 0 ? limit : -1;
  }
  double farthest() const {
    double farthest = 0;
    for (std::size_t i = 0; i < bundle_.count; ++i) farthest = std::max(farthest, bundle_.limit[i]);
    return farthest;
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
  std::array<std::uint32_t, WideBundle::size> numbers_;
  Beam first_;                     // of the bundle
  glm::dvec3 v_low_{}, v_high_{};  // between which the directions of the bundle lie
  double reach_ = unknown;         // up to where it has to be narrow: not known before a second ray asks
  std::vector<std::uint32_t> alone_;
};

}  // namespace durero::accel
