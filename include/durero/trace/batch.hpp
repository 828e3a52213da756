#pragma once
/// The first hits of a block of rays, eight pairs of a ray and an element at a time in lanes. A ray that needs more
/// than that (numbers out of the ordinary, a start on several elements, doubt about one element, or two elements whose
/// points are not told apart) is left to be answered alone, from the beginning.

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/scene/query.hpp"
#include "durero/trace/packet.hpp"
#include "durero/trace/picked.hpp"

namespace durero::trace {

/// One block of rays against a source of candidates (trace/candidates.hpp). A Kernel has
///   Findings, the result of its triage(packet, tipo, findings) in lanes, with the bits hit and undecided;
///   Point, what it keeps of a hit, by point(findings, lane): its parameter is between low() and high(), ∞ by default;
///   triage(columns, which, shape, findings by eights) too, for a source that takes rays in columns;
///   counted, true, if it is to be known how many pairs were tested;
///   hit(number, ray, source, own, point), told the nearest point of a ray, by its number in the block, and the
///   source's name of the element; or miss(number).
/// Rays that start on one element are left alone too, unless it has
///   triage_from(packet, tipo, findings), of rays that start on their elements, and
///   hit_own(number, ray, e, point), told in place of hit where the nearest point is one of that element of the scene.
template <class Source, class Kernel>
class Batch {
  static constexpr bool counted = requires { Kernel::counted; };

 public:
  /// All of these must outlive it.
  Batch(const Source& source, Picked<const scene::Query> queries, Kernel& kernel)
      : source_(source), kernel_(kernel), nearest_(queries.size()) {
    const bool none_apart = source.extraordinary().empty();
    rays_ = rays_of(source, queries, [&](std::size_t i, const scene::Query& query, const Ray& ray) {
      nearest_[i].alone = !ray.ordinary || query.en.size() > most_starts || !none_apart;
      some_start_ |= !nearest_[i].alone && ray.start() != nothing;
    });
  }

  /// Tells the kernel of all rays but those that are left alone.
  void answer() {
    if constexpr (most_starts > 0) test_starts();
    source_.pairs(
        rays_, [&](std::uint32_t number) { return nearest_[number].alone ? 0 : nearest_[number].point.high(); },
        Take{*this}, [&] { flush(); });
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

  /// answer(number) for the rays that are left alone.
  template <class Answer>
  void for_each_alone(Answer answer) const {
    for (std::uint32_t number = 0; number < nearest_.size(); ++number) {
      if (nearest_[number].alone) answer(number);
    }
  }

  /// As the kernel wants it: how many pairs of a ray and an element the lanes decided, for the rays not left alone.
  std::uint64_t decided() const noexcept
    requires(counted)
  {
    return decided_;
  }

 private:
  static constexpr std::size_t most_starts = requires { &Kernel::triage_from; } ? 1 : 0;  // of a ray in lanes

  /// Of one ray, so far.
  struct Nearest {
    typename Kernel::Point point{};
    scene::ElementRef own{};
    std::uint32_t tested = 0;
    bool alone = false, on_start = false;
  };

  static void count(Nearest& nearest) {
    if constexpr (counted) ++nearest.tested;
  }

  void tell_hit(std::uint32_t number, const Nearest& nearest) {
    if constexpr (most_starts > 0)
      if (nearest.on_start) {
        const scene::ElementRef e = source_.element(rays_[number].start());
        return kernel_.hit_own(number, rays_[number], e, nearest.point);
      }
    kernel_.hit(number, rays_[number], source_, nearest.own, nearest.point);
  }

  /// Each ray against the element that it starts on, which the source does not know of.
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
    for (std::size_t lane = 0; lane < queue.count; ++lane) {
      Nearest& nearest = nearest_[queue.numbers[lane]];
      count(nearest);
      nearest.alone = (findings_.undecided >> lane & 1) != 0;
      nearest.on_start = (findings_.hit >> lane & 1) != 0;
      if (nearest.on_start) nearest.point = kernel_.point(findings_, lane);
    }
    queue.count = 0;
  }

  /// What is taken, one by one or of rays in columns.
  struct Take {
    Batch& batch;
    bool starts() const { return batch.some_start_; }
    void operator()(std::uint32_t number, scene::ElementRef own) const { batch.take(number, own); }
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

  void flush() {
    for (Queue& queue : queues_) test(queue);
  }

  void test(Queue& queue) {
    if (queue.count == 0) return;
    kernel_.triage(queue.packet, queue.elements[0].tipo, findings_);
    const unsigned used = (1u << queue.count) - 1;
    for (std::size_t lane = 0; lane < queue.count; ++lane) count(nearest_[queue.numbers[lane]]);
    keep(findings_, used, queue.numbers.data(), [&](std::size_t lane) { return queue.elements[lane]; });
    queue.count = 0;
  }

  /// The rays that have a bit against one element, eight by eight. A bit for each whose limit may have changed.
  std::uint64_t test(const RayColumns& rays, std::span<const std::uint32_t> numbers, std::uint64_t which,
                     scene::ElementRef own) {
    if (some_start_) which &= ~starting_on(rays, which, own);
    if (which == 0) return 0;
    source_.visit(own, [&](const auto& shape) { kernel_.triage(rays, which, shape, of_columns_); });
    std::uint64_t changed = 0;
    for (std::uint64_t eights = eights_of(which); eights != 0; eights &= eights - 1) {
      const auto at = static_cast<std::size_t>(std::countr_zero(eights));
      const auto used = static_cast<unsigned>(which >> at & ((1u << Packet::size) - 1));
      for (unsigned left = used; left != 0; left &= left - 1)
        count(nearest_[numbers[at + static_cast<std::size_t>(std::countr_zero(left))]]);
      const auto& findings = of_columns_[at / Packet::size];
      keep(findings, used, &numbers[at], [&](std::size_t) { return own; });
      changed |= std::uint64_t{(findings.hit | findings.undecided) & used} << at;
    }
    return changed;
  }

  /// Of the lanes that are used, what was found of the rays of those numbers and the elements of that name.
  template <class Name>
  void keep(const typename Kernel::Findings& findings, unsigned used, const std::uint32_t* numbers, Name name) {
    for (unsigned left = findings.undecided & used; left != 0; left &= left - 1)
      nearest_[numbers[std::countr_zero(left)]].alone = true;
    for (unsigned left = findings.hit & used; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      keep_nearest(nearest_[numbers[lane]], name(lane), kernel_.point(findings, lane));
    }
  }

  static void keep_nearest(Nearest& nearest, scene::ElementRef own, const typename Kernel::Point& point) {
    if (point.low() > nearest.point.high()) return;
    if (!(point.high() < nearest.point.low())) nearest.alone = true;
    nearest.point = point;
    nearest.own = own;
    nearest.on_start = false;
  }

  const Source& source_;
  Kernel& kernel_;
  std::vector<Ray> rays_;
  std::vector<Nearest> nearest_;
  bool some_start_ = false;  // on an element, of those not left alone
  Queues queues_{};
  typename Kernel::Findings findings_{};
  std::array<typename Kernel::Findings, RayColumns::size / Packet::size> of_columns_{};
  std::uint64_t decided_ = 0;
};

}  // namespace durero::trace
