#pragma once
/// Packet traversal of the wide hierarchy. Consecutive rays that stay close together form a bundle of up to 64. The
/// traversal opens a node once for the whole bundle, and tests each ray against the box of an element that the bundle
/// reaches. The choice of bundles affects the time only: a bundle's box test passes wherever the test of one of its
/// rays does (wide_node.hpp).

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/accel/wide/coherent_run.hpp"
#include "durero/accel/wide/frustum.hpp"
#include "durero/accel/wide/leaf_columns.hpp"
#include "durero/accel/wide/packet_eights.hpp"
#include "durero/accel/wide/traversal_stack.hpp"
#include "durero/accel/wide/wide_node.hpp"

namespace durero::accel {

/// PairCandidates::pairs for coherent rays, over a tree with nodes(), leaves() and spacing(). Incoherent rays are
/// handed back.
template <class Tree, class Limit, class Visitor, class Flush>
class PacketTraversal {
 public:
  using Numbers = std::array<std::uint32_t, WidePacket::size>;  ///< of the bundle's rays

  /// @{ Whether `Take` tests a whole bundle against an element. Then take(columns, numbers, which, element) answers a
  /// bit for each ray whose limit may have changed, and take.starts() answers whether the columns must hold the
  /// elements that the rays start on.
  static constexpr bool takes_many =
      requires(Visitor& take, const trace::RayColumns& rays, const Numbers& numbers, scene::ElementRef element) {
        { take(rays, numbers, std::uint64_t{}, element) } -> std::same_as<std::uint64_t>;
        { take.starts() } -> std::same_as<bool>;
      };
  /// Whether the query is any-hit: each ray is a segment whose limit is 1 until a hit is found, and 0 from then on.
  static constexpr bool takes_any = [] {
    if constexpr (requires { Visitor::any_hit; }) return takes_many && Visitor::any_hit;
    return false;
  }();
  /// @}

  /// The traversal keeps references to its arguments, which must outlive it. Precondition: the tree has a node.
  PacketTraversal(const Tree& tree, std::span<const trace::Ray> rays, Limit& limit, Visitor& take, Flush& flush)
      : nodes_(tree.nodes()),
        blocks_(tree.leaves().blocks()),
        rows_(tree.leaves().rows()),
        large_(nodes_.size_bytes() > LeafColumns::nearby),
        narrow_(widest * tree.spacing()),
        rays_(rays),
        limit_(limit),
        take_(take),
        flush_(flush) {
    if constexpr (takes_many) starts_ = take.starts();
    const std::size_t root = 0;
    for (int i = 0; i < 3; ++i) {
      const auto& low = nodes_[root].planes[static_cast<std::size_t>(i)];
      const auto& high = nodes_[root].planes[static_cast<std::size_t>(i) + 3];
      all_.low[i] = static_cast<double>(*std::ranges::min_element(low));
      all_.high[i] = static_cast<double>(*std::ranges::max_element(high));
    }
  }

  /// Whether the rays are coherent enough to look for bundles. Of 64 pairs of consecutive rays, spread over all, a
  /// quarter must fit into one bundle; with fewer, few runs reach a bundle's least useful length. True for 256 rays or
  /// fewer.
  bool some_company() const {
    if (rays_.size() <= 4 * asked) return true;
    std::size_t joined = 0;
    for (std::size_t i = 0; i < asked && 4 * joined < asked; ++i) {
      const std::size_t at = i * (rays_.size() - 1) / asked;
      const double limit = limit_(static_cast<std::uint32_t>(at));
      if (limit > 0 && CoherentRun(rays_[at], all_, limit).join(rays_[at + 1], narrow_)) ++joined;
    }
    return 4 * joined >= asked;
  }
  /// Adds the next ray, and its limit. Precondition: the limit is not 0.
  void add(std::uint32_t number, double limit) {
    coming_.set(number, rays_[number], limit, starts_);
    if (coming_.count == WidePacket::size) part(false);
  }
  /// Traverses with the rays that still wait, and appends the numbers of the incoherent rays to `alone`.
  void finish(std::vector<std::uint32_t>& alone) {
    if (coming_.count > 0) part(true);
    alone.insert(alone.end(), alone_.begin(), alone_.end());
  }

 private:
  static constexpr double widest = takes_any ? 4 : 2;            // the greatest width of a bundle, in spacings
  static constexpr std::size_t least_worth = takes_any ? 3 : 6;  // the least rays of a useful bundle
  static constexpr std::size_t asked = 64;                       // sampled pairs of consecutive rays
  static constexpr std::size_t eight = WidePacket::eight;

  /// A bundle and its rays' numbers.
  struct PendingRays {
    void set(std::uint32_t number, const trace::Ray& ray, double limit, bool starts) {
      numbers[count] = number;
      if (starts) bundle.rays.set_start(count, ray.start());
      bundle.set(count++, ray, limit);
    }
    /// Fills the last group of eight with rays that take no part, and bounds the bundle. False where the rays cannot
    /// share one.
    bool gathered() {
      const std::size_t places = whole_eights(count);
      for (std::size_t place = count; place < places; ++place) bundle.move(count - 1, place), bundle.limit[place] = -1;
      invert(bundle, places);
      return gather(bundle, 0, places);
    }
    WidePacket bundle;
    Numbers numbers;  // only the first `count` are set
    std::size_t count = 0;
  };
  static constexpr std::size_t whole_eights(std::size_t count) { return (count + eight - 1) / eight * eight; }

  /// Splits the waiting rays into narrow bundles and traverses with each. Rays that may still gain neighbours keep
  /// waiting, unless `all` says that no more will come.
  void part(bool all) {
    if constexpr (takes_any) {
      part_segments(all);
    } else {
      part_rays(all);
    }
  }
  void part_rays(bool all) {
    if (coming_.count >= least_worth && coming_.gathered() && narrow(coming_.bundle)) {
      walk(coming_);
      coming_.count = 0;
      return;
    }
    std::size_t begin = 0;
    while (begin < coming_.count) {
      CoherentRun run(ray(begin), all_, coming_.bundle.limit[begin]);
      std::size_t end = begin + 1;
      while (end < coming_.count && run.join(ray(end), narrow_)) ++end;
      if (end == coming_.count && begin > 0 && !all) break;
      walk_apart(begin, end);
      begin = end;
    }
    leave(begin);
  }
  /// Removes the first `begin` waiting rays.
  void leave(std::size_t begin) {
    const std::size_t left = coming_.count - begin;
    for (std::size_t i = 0; i < left; ++i)
      coming_.bundle.move(begin + i, i), coming_.numbers[i] = coming_.numbers[begin + i];
    coming_.count = left;
  }

  /// Traverses with the longest narrow prefix of the waiting segments, found by halving. The rest waits until 64 are
  /// there, unless `all` says that no more will come.
  void part_segments(bool all) {
    while (coming_.count == WidePacket::size || (all && coming_.count > 0)) {
      const std::size_t come = coming_.count;
      std::size_t count = come;
      while (count >= least_worth && !walk_first(count)) count = (count + 1) / 2;
      if (count < least_worth) alone_.insert(alone_.end(), coming_.numbers.begin(), coming_.numbers.begin() + count);
      coming_.count = come;  // an any-hit traversal may have compacted coming_
      leave(count);
    }
  }
  /// Traverses with the first `count` waiting segments, if their frustum is narrow. False where it is not.
  bool walk_first(std::size_t count) {
    PendingRays* some = &coming_;
    if (count < coming_.count) {
      some = &apart_;
      apart_.count = 0;
      for (std::size_t place = 0; place < count; ++place)
        apart_.set(coming_.numbers[place], ray(place), coming_.bundle.limit[place], starts_);
    }
    if (!some->gathered()) return false;
    const Frustum beam = beam_of(some->bundle, all_);
    if (!(beam.width <= narrow_)) return false;
    walk_any(*some, beam);
    return true;
  }

  const trace::Ray& ray(std::size_t place) const { return rays_[coming_.numbers[place]]; }

  /// Traverses with the waiting rays begin … end as one bundle, or hands them back as incoherent.
  void walk_apart(std::size_t begin, std::size_t end) {
    apart_.count = 0;
    if (end - begin >= least_worth)
      for (std::size_t place = begin; place < end; ++place)
        apart_.set(coming_.numbers[place], ray(place), coming_.bundle.limit[place], starts_);
    if (apart_.count > 0 && apart_.gathered()) return walk(apart_);
    for (std::size_t place = begin; place < end; ++place) alone_.push_back(coming_.numbers[place]);
  }

  /// Whether the bundle is narrow, by the bound of CoherentRun::join on all its rays.
  bool narrow(const WidePacket& bundle) const {
    const double reach = std::max(stretch(all_, Beam(ray(0)), bundle.limit[0]).exit, 0.0);
    bool narrow = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double apart = bundle.p_high[axis] - bundle.p_low[axis];
      narrow &= apart + reach * (bundle.v_high[axis] - bundle.v_low[axis]) <= narrow_;
    }
    return narrow;
  }

  /// Closest-hit traversal, nearest box first, past boxes that are entered beyond the bundle's greatest limit. An
  /// element is tested as soon as the traversal reaches it, even for few rays, because a limit that falls early prunes
  /// more.
  void walk(PendingRays& some) {
    if (large_) gather(eights_, some.bundle);
    double limit = farthest(some.bundle);
    TraversalStack waiting;
    open(waiting, some.bundle, 0, limit);
    while (!waiting.empty()) {
      const auto [entry, node, place] = waiting.pop();
      if (entry > latest_entry(limit)) continue;
      const WideChild& child = nodes_[node].children[place];
      if (child.kind == WideChild::Kind::node) {
        open(waiting, some.bundle, child.index, limit);
        continue;
      }
      if (child.kind == WideChild::Kind::block) {
        limit = walk_block(some, child.index, limit);
        continue;
      }
      limit = take_leaf(some, nodes_[node], place, limit);
    }
  }

  /// Tests an element of a node for the rays that meet its box. The greatest limit of the bundle from then on.
  double take_leaf(PendingRays& some, const WideNode& node, std::size_t place, double limit) {
    const std::uint64_t which = met_by_now(node, place, some.bundle);
    if (which == 0) return limit;
    const std::uint64_t changed = take(some, which, node.children[place].element());
    return changed == 0 ? limit : brought_up_to_date(some, changed);
  }

  /// Tests the triangles of a block, nearest box first. The greatest limit of the bundle from then on.
  double walk_block(PendingRays& some, std::uint32_t block, double limit) {
    unpack(blocks_, block, unpacked_);
    WideNode::Entries entries;
    TraversalStack waiting;
    waiting.push(block, met(unpacked_, some.bundle, limit, entries), entries);
    while (!waiting.empty()) {
      const auto [entry, parent, place] = waiting.pop();
      if (entry > latest_entry(limit)) break;
      limit = take_leaf(some, unpacked_, place, limit);
    }
    return limit;
  }

  /// Tests an element for the rays in `which`. The answer has a bit for each ray whose limit may have changed.
  std::uint64_t take(PendingRays& some, std::uint64_t which, scene::ElementRef own) {
    if constexpr (takes_many) {
      return take_(some.bundle.rays, some.numbers, which, own);
    } else {
      for (std::uint64_t left = which; left != 0; left &= left - 1)
        take_(some.numbers[static_cast<std::size_t>(std::countr_zero(left))], own);
      flush_();
      return which;
    }
  }

  std::uint64_t met_by_now(const WideNode& node, std::size_t child, const WidePacket& bundle) const {
    if (large_) return met_by(node, child, bundle, eights_);
    WideMeetings meeting;
    met_by(node, 1u << child, bundle, meeting);
    return meeting[child];
  }

  void open(TraversalStack& waiting, const WidePacket& bundle, std::uint32_t node, double limit) const {
    WideNode::Entries entries;
    const unsigned bits = met(nodes_[node], bundle, limit, entries);
    ask_for(nodes_[node], bits);
    waiting.push(node, bits, entries);
  }
  void ask_for(const WideNode& node, unsigned children) const {
    if (!large_) return;
    for (; children != 0; children &= children - 1) {
      const WideChild& child = node.children[static_cast<std::size_t>(std::countr_zero(children))];
      if (child.kind == WideChild::Kind::node) {
        trace::ask_for(nodes_[child.index]);
      } else if (child.kind == WideChild::Kind::block) {
        blocks_[child.index].ask();
      } else {
        rows_.ask_for(child.element());
      }
    }
  }

  /// Reads the limits of the rays in `which` again. The greatest limit of the bundle.
  double brought_up_to_date(PendingRays& some, std::uint64_t which) {
    for (std::uint64_t left = which; left != 0; left &= left - 1) {
      const auto place = static_cast<std::size_t>(std::countr_zero(left));
      const double limit = limit_(some.numbers[place]);
      some.bundle.limit[place] = limit > 0 ? limit : -1;
    }
    return large_ ? bring_up_to_date(eights_, some.bundle, which) : farthest(some.bundle);
  }

  /// Any-hit traversal: in no particular order, all elements of a node at once, until every ray has a hit.
  void walk_any(PendingRays& some, Frustum beam) {
    std::array<std::uint32_t, most_waiting> waiting;
    std::size_t size = 1;
    waiting[0] = 0;
    std::uint64_t open = ~std::uint64_t{} >> (WidePacket::size - some.count);
    while (size > 0) {
      const WideNode& node = opened(waiting[--size]);
      const unsigned bits = met(node, beam);
      if (&node != &unpacked_) ask_for(node, bits);
      unsigned elements = 0;
      for (unsigned left = bits; left != 0; left &= left - 1) {
        const auto place = static_cast<std::size_t>(std::countr_zero(left));
        const WideChild& child = node.children[place];
        if (child.kind == WideChild::Kind::element) {
          elements |= 1u << place;
        } else {
          waiting[size++] = child.index | (child.kind == WideChild::Kind::block ? LeafColumns::in_block : 0);
        }
      }
      if (elements == 0) continue;
      const std::uint64_t still = take_elements(some, node, elements, open);
      if (still == 0) return;
      if (still == open) continue;
      open = still;
      if (close_up(some, open)) beam = beam_of(some.bundle, all_);
    }
  }

  /// The node of an index; or a block's, where LeafColumns::in_block is set.
  const WideNode& opened(std::uint32_t index) {
    if ((index & LeafColumns::in_block) == 0) return nodes_[index];
    unpack(blocks_, index & ~LeafColumns::in_block, unpacked_);
    return unpacked_;
  }

  /// Tests some elements of a node for the rays in `open`, which have no hit yet. The rays that still have none.
  std::uint64_t take_elements(PendingRays& some, const WideNode& node, unsigned elements, std::uint64_t open) {
    WideMeetings meeting;
    met_by(node, elements, some.bundle, meeting);
    for (; elements != 0; elements &= elements - 1) {
      const auto place = static_cast<std::size_t>(std::countr_zero(elements));
      const std::uint64_t which = meeting[place] & open;
      if (which != 0) open &= ~take_(some.bundle.rays, some.numbers, which, node.children[place].element());
    }
    return open;
  }

  /// Compacts the bundle to the rays in `open`, if that saves a quarter of its groups of eight, and narrows its bounds;
  /// otherwise the rays with a hit are only switched off. Whether the bundle was compacted.
  static bool close_up(PendingRays& some, std::uint64_t& open) {
    const auto count = static_cast<std::size_t>(std::popcount(open));
    if (4 * whole_eights(count) > 3 * (some.bundle.end - some.bundle.begin)) {
      for (std::size_t place = 0; place < some.count; ++place)
        if ((open >> place & 1) == 0) some.bundle.limit[place] = -1;
      return false;
    }
    some.count = 0;
    for (std::uint64_t left = open; left != 0; left &= left - 1) {
      const auto place = static_cast<std::size_t>(std::countr_zero(left));
      some.numbers[some.count] = some.numbers[place];
      some.bundle.move(place, some.count++);
    }
    some.gathered();
    open = ~std::uint64_t{} >> (WidePacket::size - count);
    return true;
  }

  std::span<const WideNode> nodes_;
  trace::TriangleBlocks blocks_;
  WideNode unpacked_;  // the block that is visited
  LeafColumns::Rows rows_;
  bool starts_ = false;  // whether some ray starts on an element, so that the columns must say which
  bool large_;           // the tree exceeds the cache: leaves are prefetched, and boxes tested by groups of eight
  double narrow_;
  std::span<const trace::Ray> rays_;
  Limit& limit_;
  Visitor& take_;
  Flush& flush_;
  surface::Box all_{};
  PendingRays coming_, apart_;
  WidePacketEights eights_;  // the groups of eight of the bundle in traversal, where large_
  std::vector<std::uint32_t> alone_;
};

}  // namespace durero::accel
