#pragma once
/// Batched closest-hit search: the first hits of a block of rays, with eight pairs of a ray and an element tested side
/// by side in lanes. Some rays are left to be answered one by one, from the beginning: rays with numbers out of the
/// ordinary, with more starts than the kernel handles, with an undecided element, or with two elements whose points are
/// not told apart; and all rays, where the source has extraordinary elements.

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/scene/query.hpp"
#include "durero/trace/packet.hpp"
#include "durero/trace/picked.hpp"
#include "durero/trace/single_rays.hpp"

namespace durero::trace {

/// A block of rays and a source of candidates (trace/candidates.hpp). A Kernel has
///   Findings              the result of its triage(packet, tipo, findings) in lanes, with the bits hit and undecided;
///   Point                 a hit's record, made by point(findings, lane): its parameter is in low() … high(), both ∞ by
///                         default;
///   bounds(findings, lane)
///                         low() and high() of that record, before it is made;
///   triage(columns, which, shape, findings by groups of eight)
///                         for a source that offers rays in columns;
///   triage(ray, block, findings)
///                         for a source that offers blocks of triangles;
///   counted               a member, if pairs may be counted: whether the tested pairs are;
///   hit(number, ray, source, own, point)
///                         called with a ray's nearest point, its number in the block, and the source's name of the
///                         element;
///   miss(number)          called for a ray without a hit.
/// A kernel may also have these two; without them, rays that start on an element are left alone:
///   triage_from(packet, tipo, findings)
///                         for rays that start on their elements;
///   hit_own(number, ray, e, point)
///                         called in place of hit where the nearest point lies on the element e that the ray starts on.
template <class Source, class Kernel>
class Batch {
  static constexpr bool countable = requires { &Kernel::counted; };

 public:
  /// The batch keeps references to its arguments, which must outlive it.
  Batch(const Source& source, IndexedView<const scene::Query> queries, Kernel& kernel)
      : source_(source), kernel_(kernel), nearest_(queries.size()) {
    if constexpr (countable) counted_ = kernel.counted;
    const bool none_apart = source.extraordinary().empty(), of_single = has_single_blocks(source);
    rays_ = rays_of(source, queries, [&](std::size_t i, const scene::Query& query, const Ray& ray) {
      nearest_[i].alone = !ray.ordinary || query.en.size() > most_starts || !none_apart;
      nearest_[i].single = of_single && in_single_range(ray);
      some_start_ |= !nearest_[i].alone && ray.start() != nothing;
    });
  }

  /// Gives the kernel the answers of all rays but those that are left alone.
  void answer() {
    if constexpr (most_starts > 0) test_starts();
    source_.pairs(
        rays_, [&](std::uint32_t number) { return nearest_[number].alone ? 0 : nearest_[number].point.high(); },
        Visitor{*this}, [&] { flush(); });
    flush();
    for (std::uint32_t number = 0; number < nearest_.size(); ++number) {
      const Nearest& nearest = nearest_[number];
      if (nearest.alone) continue;
      decided_ += nearest.tested;
      if (nearest.point.low() < no_limit) {
        tell_hit(number, nearest);
      } else {
        kernel_.miss(number);
      }
    }
  }

  /// answer(number) for each ray that is left alone. Precondition: answer() was called.
  template <class Answer>
  void for_each_alone(Answer answer) const {
    for (std::uint32_t number = 0; number < nearest_.size(); ++number) {
      if (nearest_[number].alone) answer(number);
    }
  }

  /// The number of pairs of a ray and an element that the lanes decided, without the rays that are left alone; 0 where
  /// they are not counted.
  std::uint64_t decided() const noexcept
    requires(countable)
  {
    return decided_;
  }

 private:
  static constexpr std::size_t most_starts = requires { &Kernel::triage_from; } ? 1 : 0;  // of a ray in lanes

  /// A ray's nearest hit so far.
  struct Nearest {
    typename Kernel::Point point{};
    scene::ElementRef own{};
    std::uint32_t tested = 0;
    bool alone = false, on_start = false, single = false;  // single: the test in binary32 serves
  };

  /// Counts a test of each ray of these bits, whose numbers begin there.
  void count(std::uint64_t which, const std::uint32_t* numbers) {
    if (!counted_) return;
    for (; which != 0; which &= which - 1) ++nearest_[numbers[std::countr_zero(which)]].tested;
  }

  void tell_hit(std::uint32_t number, const Nearest& nearest) {
    if constexpr (most_starts > 0)
      if (nearest.on_start) {
        const scene::ElementRef e = source_.element(rays_[number].start());
        return kernel_.hit_own(number, rays_[number], e, nearest.point);
      }
    kernel_.hit(number, rays_[number], source_, nearest.own, nearest.point);
  }

  /// Tests each ray against the element that it starts on, whose further points are not left to the source.
  void test_starts() {
    if (!some_start_) return;
    for (std::uint32_t number = 0; number < nearest_.size(); ++number) {
      const scene::ElementRef start = rays_[number].start();
      if (start == nothing || nearest_[number].alone) continue;
      Queue& queue = queues_[static_cast<std::size_t>(start.tipo)];
      queue.push(source_, number, rays_[number], start);
      if (queue.full()) test_start(queue);
    }
    for (Queue& queue : queues_) test_start(queue);
  }
  void test_start(Queue& queue) {
    if (queue.count == 0) return;
    kernel_.triage_from(queue.packet, queue.elements[0].tipo, findings_);
    count((1u << queue.count) - 1, queue.numbers.data());
    for (std::size_t lane = 0; lane < queue.count; ++lane) {
      Nearest& nearest = nearest_[queue.numbers[lane]];
      nearest.alone = (findings_.undecided >> lane & 1) != 0;
      nearest.on_start = (findings_.hit >> lane & 1) != 0;
      if (nearest.on_start) nearest.point = kernel_.point(findings_, lane);
    }
    queue.count = 0;
  }

  /// The `take` of PairCandidates::pairs, for one ray and for a bundle in columns.
  struct Visitor {
    Batch& batch;
    bool starts() const { return batch.some_start_; }
    void operator()(std::uint32_t number, scene::ElementRef own) const { batch.take(number, own); }
    void operator()(std::uint32_t number, const TriangleBlock& block, scene::ElementRef first) const {
      batch.take(number, block, first);
    }
    template <class Numbers>
    std::uint64_t operator()(const RayColumns& rays, const Numbers& numbers, std::uint64_t which,
                             scene::ElementRef own) const {
      return batch.test(rays, numbers, which, own);
    }
  };

  void take(std::uint32_t number, scene::ElementRef own) {
    if (rays_[number].start() == own) return;
    Queue& queue = queues_[static_cast<std::size_t>(own.tipo)];
    queue.push(source_, number, rays_[number], own);
    if (queue.full()) test(queue);
  }

  /// Tests a ray against a block of triangles, the first of which has the name `first`.
  void take(std::uint32_t number, const TriangleBlock& block, scene::ElementRef first) {
    Nearest& nearest = nearest_[number];
    if (counted_) nearest.tested += block.count();
    if (nearest.single && possible_hits(rays_[number], block, nearest.point.high()) == 0) return;
    kernel_.triage(rays_[number], block, findings_);
    const unsigned others = ~lane_of(rays_[number].start(), first);  // than the triangle that the ray starts on
    if ((findings_.undecided & others) != 0) nearest.alone = true;
    for (unsigned left = findings_.hit & others; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(left));
      keep_nearest(nearest, {first.tipo, first.index + lane}, findings_, lane);
    }
  }

  void flush() {
    for (Queue& queue : queues_) test(queue);
  }

  void test(Queue& queue) {
    if (queue.count == 0) return;
    kernel_.triage(queue.packet, queue.elements[0].tipo, findings_);
    const unsigned used = (1u << queue.count) - 1;
    count(used, queue.numbers.data());
    keep(findings_, used, queue.numbers.data(), [&](std::size_t lane) { return queue.elements[lane]; });
    queue.count = 0;
  }

  /// Tests an element for the rays in `which`, in groups of eight. The answer has a bit for each ray whose limit may
  /// have changed.
  std::uint64_t test(const RayColumns& rays, std::span<const std::uint32_t> numbers, std::uint64_t which,
                     scene::ElementRef own) {
    if (some_start_) which &= ~starting_on(rays, which, own);
    if (which == 0) return 0;
    source_.visit(own, [&](const auto& shape) { kernel_.triage(rays, which, shape, of_columns_); });
    count(which, numbers.data());
    std::uint64_t changed = 0;
    for (std::uint64_t eights = eights_of(which); eights != 0; eights &= eights - 1) {
      const auto at = static_cast<std::size_t>(std::countr_zero(eights));
      const auto used = static_cast<unsigned>(which >> at & ((1u << Packet::size) - 1));
      const auto& findings = of_columns_[at / Packet::size];
      keep(findings, used, &numbers[at], [&](std::size_t) { return own; });
      changed |= std::uint64_t{(findings.hit | findings.undecided) & used} << at;
    }
    return changed;
  }

  /// Keeps the findings of the lanes in `used`, for the rays of these numbers and the elements name(lane).
  template <class Name>
  void keep(const typename Kernel::Findings& findings, unsigned used, const std::uint32_t* numbers, Name name) {
    for (unsigned left = findings.undecided & used; left != 0; left &= left - 1)
      nearest_[numbers[std::countr_zero(left)]].alone = true;
    for (unsigned left = findings.hit & used; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      keep_nearest(nearest_[numbers[lane]], name(lane), findings, lane);
    }
  }

  void keep_nearest(Nearest& nearest, scene::ElementRef own, const typename Kernel::Findings& findings,
                    std::size_t lane) const {
    const auto [low, high] = kernel_.bounds(findings, lane);
    if (low > nearest.point.high()) return;
    if (!(high < nearest.point.low())) nearest.alone = true;
    nearest.point = kernel_.point(findings, lane);
    nearest.own = own;
    nearest.on_start = false;
  }

  const Source& source_;
  Kernel& kernel_;
  std::vector<Ray> rays_;
  std::vector<Nearest> nearest_;
  bool some_start_ = false;  // whether some ray that is not left alone starts on an element
  bool counted_ = false;     // whether the tested pairs are counted
  Queues queues_{};
  typename Kernel::Findings findings_{};
  std::array<typename Kernel::Findings, RayColumns::size / Packet::size> of_columns_{};
  std::uint64_t decided_ = 0;
};

}  // namespace durero::trace
