#pragma once
/// Rays that follow each other and stay close together, on their way through the wide hierarchy as one bundle: a node
/// is opened once for all of them, and each is tested against the boxes of the elements that the bundle reaches. Which
/// rays are bundled costs time only: the tests of bundles pass over nothing that those of single rays do not
/// (wide_node.hpp).

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/accel/wide_beam.hpp"
#include "durero/accel/wide_eights.hpp"
#include "durero/accel/wide_leaves.hpp"
#include "durero/accel/wide_node.hpp"
#include "durero/accel/wide_run.hpp"
#include "durero/accel/wide_stack.hpp"

namespace durero::accel {

/// PairCandidates::pairs of the rays that find company, over a tree that has nodes(), leaves() and spacing().
template <class Tree, class Limit, class Take, class Flush>
class WideBundles {
 public:
  using Numbers = std::array<std::uint32_t, WideBundle::size>;  ///< of rays

  /// @{ What is taken of rays in columns may be told together: take(columns, numbers, which, element) answers a bit for
  /// each ray whose limit has changed; take.starts(), whether the columns are to say what the rays start on.
  static constexpr bool takes_many =
      requires(Take& take, const trace::RayColumns& rays, const Numbers& numbers, scene::ElementRef element) {
        { take(rays, numbers, std::uint64_t{}, element) } -> std::same_as<std::uint64_t>;
        { take.starts() } -> std::same_as<bool>;
      };
  /// And its limit is 1, until it is 0, as where any hit on a segment is an answer.
  static constexpr bool takes_any = [] {
    if constexpr (requires { Take::any_hit; }) return takes_many && Take::any_hit;
    return false;
  }();
  /// @}

  /// All of these must outlive it. Precondition: the tree has a node.
  WideBundles(const Tree& tree, std::span<const trace::Ray> rays, Limit& limit, Take& take, Flush& flush)
      : nodes_(tree.nodes()),
        rows_(tree.leaves().rows()),
        large_(nodes_.size_bytes() > WideLeaves::nearby),
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

  /// Whether it is worth while to look for company: of some rays, all over, a quarter may walk with the one after them.
  /// Where fewer do, the runs that are long enough to be worth it are few.
  bool some_company() const {
    if (rays_.size() <= 4 * asked) return true;
    std::size_t joined = 0;
    for (std::size_t i = 0; i < asked && 4 * joined < asked; ++i) {
      const std::size_t at = i * (rays_.size() - 1) / asked;
      const double limit = limit_(static_cast<std::uint32_t>(at));
      if (limit > 0 && WideRun(rays_[at], all_, limit).join(rays_[at + 1], narrow_)) ++joined;
    }
    return 4 * joined >= asked;
  }
  /// The next ray, and its limit. Precondition: that is not 0.
  void add(std::uint32_t number, double limit) {
    coming_.set(number, rays_[number], limit, starts_);
    if (coming_.count == WideBundle::size) part(false);
  }
  /// No ray comes any more. Those that found no company are appended to `alone`.
  void finish(std::vector<std::uint32_t>& alone) {
    if (coming_.count > 0) part(true);
    alone.insert(alone.end(), alone_.begin(), alone_.end());
  }

 private:
  static constexpr double widest = takes_any ? 4 : 2;            // of a bundle, in spacings of the elements
  static constexpr std::size_t least_worth = takes_any ? 3 : 6;  // rays of a bundle that is worth it
  static constexpr std::size_t asked = 64;                       // rays, whether they have company
  static constexpr std::size_t eight = WideBundle::eight;

  /// Some rays, and their numbers.
  struct Some {
    void set(std::uint32_t number, const trace::Ray& ray, double limit, bool starts) {
      numbers[count] = number;
      if (starts) bundle.rays.set_start(count, ray.start());
      bundle.set(count++, ray, limit);
    }
    /// Whether they walk together. The last eight is filled up by rays that take no part.
    bool gathered() {
      const std::size_t places = whole_eights(count);
      for (std::size_t place = count; place < places; ++place) bundle.move(count - 1, place), bundle.limit[place] = -1;
      invert(bundle, places);
      return gather(bundle, 0, places);
    }
    WideBundle bundle;
    Numbers numbers;  // the first `count`
    std::size_t count = 0;
  };
  static constexpr std::size_t whole_eights(std::size_t count) { return (count + eight - 1) / eight * eight; }

  /// Those that have come as one where they stay narrow, or those that follow each other and do. The last of these wait
  /// for more, unless these are all.
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
      WideRun run(ray(begin), all_, coming_.bundle.limit[begin]);
      std::size_t end = begin + 1;
      while (end < coming_.count && run.join(ray(end), narrow_)) ++end;
      if (end == coming_.count && begin > 0 && !all) break;
      walk_apart(begin, end);
      begin = end;
    }
    leave(begin);
  }
  /// The first of those that have come, up to some, go.
  void leave(std::size_t begin) {
    const std::size_t left = coming_.count - begin;
    for (std::size_t i = 0; i < left; ++i)
      coming_.bundle.move(begin + i, i), coming_.numbers[i] = coming_.numbers[begin + i];
    coming_.count = left;
  }

  /// As many of the first as stay narrow, by halves of them, while so many have come or all; the others wait for more.
  void part_segments(bool all) {
    while (coming_.count == WideBundle::size || (all && coming_.count > 0)) {
      const std::size_t come = coming_.count;
      std::size_t count = come;
      while (count >= least_worth && !walk_first(count)) count = (count + 1) / 2;
      if (count < least_worth) alone_.insert(alone_.end(), coming_.numbers.begin(), coming_.numbers.begin() + count);
      coming_.count = come;  // those that closed up were fewer in the end
      leave(count);
    }
  }
  /// Whether they are narrow together, so that they walk.
  bool walk_first(std::size_t count) {
    Some* some = &coming_;
    if (count < coming_.count) {
      some = &apart_;
      apart_.count = 0;
      for (std::size_t place = 0; place < count; ++place)
        apart_.set(coming_.numbers[place], ray(place), coming_.bundle.limit[place], starts_);
    }
    if (!some->gathered()) return false;
    const WideBeam beam = beam_of(some->bundle, all_);
    if (!(beam.width <= narrow_)) return false;
    walk_any(*some, beam);
    return true;
  }

  const trace::Ray& ray(std::size_t place) const { return rays_[coming_.numbers[place]]; }

  /// Those at begin … end, as one or alone.
  void walk_apart(std::size_t begin, std::size_t end) {
    apart_.count = 0;
    if (end - begin >= least_worth)
      for (std::size_t place = begin; place < end; ++place)
        apart_.set(coming_.numbers[place], ray(place), coming_.bundle.limit[place], starts_);
    if (apart_.count > 0 && apart_.gathered()) return walk(apart_);
    for (std::size_t place = begin; place < end; ++place) alone_.push_back(coming_.numbers[place]);
  }

  /// As WideRun has it.
  bool narrow(const WideBundle& bundle) const {
    const double reach = std::max(stretch(all_, Beam(ray(0)), bundle.limit[0]).exit, 0.0);
    bool narrow = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double apart = bundle.p_high[axis] - bundle.p_low[axis];
      narrow &= apart + reach * (bundle.v_high[axis] - bundle.v_low[axis]) <= narrow_;
    }
    return narrow;
  }

  /// The nearest first. What lies beyond the limits is passed over. An element is tested as the bundle comes to it, for
  /// however few of the rays: so the limits fall at once, and with them what is left to be done.
  void walk(Some& some) {
    if (large_) gather(eights_, some.bundle);
    double limit = farthest(some.bundle);
    WideStack waiting;
    open(waiting, some.bundle, 0, limit);
    while (!waiting.empty()) {
      const auto [entry, node, place] = waiting.pop();
      if (entry > latest_entry(limit)) continue;
      const WideChild& child = nodes_[node].children[place];
      if (child.kind == WideChild::Kind::node) {
        open(waiting, some.bundle, child.index, limit);
        continue;
      }
      const std::uint64_t which = met_by_now(nodes_[node], place, some.bundle);
      if (which == 0) continue;
      const std::uint64_t changed = take(some, which, child.element());
      if (changed != 0) limit = brought_up_to_date(some, changed);
    }
  }

  /// Takes an element for the rays that have a bit. A bit for each whose limit may have changed.
  std::uint64_t take(Some& some, std::uint64_t which, scene::ElementRef own) {
    if constexpr (takes_many) {
      return take_(some.bundle.rays, some.numbers, which, own);
    } else {
      for (std::uint64_t left = which; left != 0; left &= left - 1)
        take_(some.numbers[static_cast<std::size_t>(std::countr_zero(left))], own);
      flush_();
      return which;
    }
  }

  std::uint64_t met_by_now(const WideNode& node, std::size_t child, const WideBundle& bundle) const {
    if (large_) return met_by(node, child, bundle, eights_);
    WideMeetings meeting;
    met_by(node, 1u << child, bundle, meeting);
    return meeting[child];
  }

  void open(WideStack& waiting, const WideBundle& bundle, std::uint32_t node, double limit) const {
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
      } else {
        rows_.ask_for(child.element());
      }
    }
  }

  /// The limits of those that have a bit, and the greatest of all.
  double brought_up_to_date(Some& some, std::uint64_t which) {
    for (std::uint64_t left = which; left != 0; left &= left - 1) {
      const auto place = static_cast<std::size_t>(std::countr_zero(left));
      const double limit = limit_(some.numbers[place]);
      some.bundle.limit[place] = limit > 0 ? limit : -1;
    }
    return large_ ? bring_up_to_date(eights_, some.bundle, which) : farthest(some.bundle);
  }

  /// In any order, the elements of a node at once, until nothing is left to be found of any ray.
  void walk_any(Some& some, WideBeam beam) {
    std::array<std::uint32_t, most_waiting> waiting;
    std::size_t size = 1;
    waiting[0] = 0;
    std::uint64_t open = ~std::uint64_t{} >> (WideBundle::size - some.count);
    while (size > 0) {
      const WideNode& node = nodes_[waiting[--size]];
      const unsigned bits = met(node, beam);
      ask_for(node, bits);
      unsigned elements = 0;
      for (unsigned left = bits; left != 0; left &= left - 1) {
        const auto place = static_cast<std::size_t>(std::countr_zero(left));
        if (node.children[place].kind == WideChild::Kind::element) {
          elements |= 1u << place;
        } else {
          waiting[size++] = node.children[place].index;
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

  /// Which of the rays that are open still are, once they are tested against some elements of a node.
  std::uint64_t take_elements(Some& some, const WideNode& node, unsigned elements, std::uint64_t open) {
    WideMeetings meeting;
    met_by(node, elements, some.bundle, meeting);
    for (; elements != 0; elements &= elements - 1) {
      const auto place = static_cast<std::size_t>(std::countr_zero(elements));
      const std::uint64_t which = meeting[place] & open;
      if (which != 0) open &= ~take_(some.bundle.rays, some.numbers, which, node.children[place].element());
    }
    return open;
  }

  /// Those that are still open come to the front where that saves a quarter of the eights, and what is between them
  /// with it; else the others take part no more. Whether they did.
  static bool close_up(Some& some, std::uint64_t& open) {
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
    open = ~std::uint64_t{} >> (WideBundle::size - count);
    return true;
  }

  std::span<const WideNode> nodes_;
  WideLeaves::Rows rows_;
  bool starts_ = false;  // some ray starts on something, and the columns say on what
  bool large_;           // so that leaves are waited for, and so many are come to that it pays to test them by eights
  double narrow_;
  std::span<const trace::Ray> rays_;
  Limit& limit_;
  Take& take_;
  Flush& flush_;
  surface::Box all_{};
  Some coming_, apart_;
  WideEights eights_;  // of the bundle that walks, the nearest first
  std::vector<std::uint32_t> alone_;
};

}  // namespace durero::accel
