#pragma once
/// Which of many segments are occluded: a block of rays at a time against a source of candidates, eight pairs of a ray
/// and an element at a time in lanes. As any point at t < 1 decides, nothing is rounded; what the triage leaves open is
/// asked of the search.

#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/trace/candidates.hpp"
#include "durero/trace/packet.hpp"
#include "durero/trace/picked.hpp"

namespace durero::trace {

/// Search::blocks_segment by the first step that can tell. Preconditions: the ray is that of the query, and ordinary;
/// the element is of the scene.
bool blocks_segment(const scene::Scene& scene, const scene::Query& query, const Ray& ray, scene::ElementRef e);

/// One block of rays against a source of candidates.
template <PairCandidates Source>
class SegmentBatch {
 public:
  /// All of these must outlive it. Precondition: a place in `occluded` for each query.
  SegmentBatch(const Source& source, Picked<const scene::Query> queries, Picked<bool> occluded)
      : source_(source), queries_(queries), occluded_(occluded), open_(queries.size(), true) {
    rays_ = rays_of(source, queries, [&](std::size_t, const scene::Query& query, const Ray& ray) {
      if (query.en.empty()) return;
      (ray.start() == nothing ? some_start_untold_ : some_start_) = true;
    });
  }

  /// Writes every answer.
  void answer() {
    for (std::uint32_t number = 0; number < queries_.size();) number = begin(number);
    for (Queue& queue : starts_) test_starts(queue);
    source_.pairs(
        rays_, [&](std::uint32_t number) { return open_[number] ? 1.0 : 0.0; }, Take{*this}, [&] { flush(); });
    flush();
    for (const scene::ElementRef e : source_.extraordinary())
      for (std::uint32_t number = 0; number < queries_.size(); ++number)
        if (open_[number] && !Origin(queries_[number].en).contains(e)) test(number, e);
  }

 private:
  /// So many rays before its turn memory is asked for what a ray starts on: as many as begin, each in some 7 ns, while
  /// memory answers, within 160 ns. Among 10⁶ elements 3 % of the time of shadow rays is saved so, by any number from 4
  /// to 64.
  static constexpr std::size_t ahead = 24;

  /// The rays from one on that are known to start on the same element are tested against it, or that one against what
  /// it starts on; the source does not know of it. The number of the next.
  std::uint32_t begin(std::uint32_t number) {
    const scene::ElementRef start = rays_[number].start();
    std::uint32_t end = number;
    do {
      occluded_[end] = false;
      ask_for_start(end + ahead);
    } while (++end < rays_.size() && start != nothing && rays_[end].start() == start);
    if (start != nothing) {
      begin_on(start, number, end);
    } else {
      begin_alone(number);
    }
    return end;
  }

  /// Of what the ray before starts on too it was asked for.
  void ask_for_start(std::size_t number) const {
    if (number >= rays_.size()) return;
    const scene::ElementRef start = rays_[number].start();
    if (start != nothing && start != rays_[number - 1].start())
      source_.visit(start, [](const auto& shape) { ask_for(shape); });
  }

  /// In lanes, as the element is ordinary.
  void begin_on(scene::ElementRef own, std::uint32_t begin, std::uint32_t end) {
    Queue& queue = starts_[static_cast<std::size_t>(own.tipo)];
    for (std::span<const Ray> left = std::span(rays_).subspan(begin, end - begin); !left.empty();) {
      const auto number = static_cast<std::uint32_t>(end - left.size());
      left = left.subspan(queue.push(source_, number, left, own));
      if (queue.full()) test_starts(queue);
    }
  }

  /// Rays out of the ordinary are answered alone.
  void begin_alone(std::uint32_t number) {
    const scene::Query& query = queries_[number];
    if (!rays_[number].ordinary) {
      Counts unseen;
      occluded_[number] = occluded_segment_among(source_, query.rayo, query.en, unseen);
      open_[number] = false;
      return;
    }
    for (const scene::ElementRef e : query.en) {
      if (source_.extraordinary().empty()) {
        begin_on(source_.own(e), number, number + 1);
      } else if (open_[number]) {
        test(number, e);
      }
    }
  }

  /// Precondition: what the ray starts on, if that is known, is another.
  bool starts_on_it_too(std::uint32_t number, scene::ElementRef own) const {
    return some_start_untold_ && Origin(queries_[number].en).contains(source_.element(own));
  }

  void test(std::uint32_t number, scene::ElementRef e) {
    if (blocks_segment(source_.scene(), queries_[number], rays_[number], e)) block(number);
  }

  void block(std::uint32_t number) {
    occluded_[number] = true;
    open_[number] = false;
  }

  /// As of Batch. A ray is open with the same limit, or not any more.
  struct Take {
    static constexpr bool any_hit = true;
    SegmentBatch& batch;
    bool starts() const { return batch.some_start_; }
    void operator()(std::uint32_t number, scene::ElementRef own) const { batch.take(number, own); }
    template <class Numbers>
    std::uint64_t operator()(const RayColumns& rays, const Numbers& numbers, std::uint64_t which,
                             scene::ElementRef own) const {
      return batch.test_columns(rays, numbers, which, own);
    }
  };

  void take(std::uint32_t number, scene::ElementRef own) {
    if (!open_[number] || rays_[number].start() == own || starts_on_it_too(number, own)) return;
    Queue& queue = queues_[static_cast<std::size_t>(own.tipo)];
    queue.push(source_, number, rays_[number], own);
    if (queue.full()) test_taken(queue);
  }

  void flush() {
    for (Queue& queue : queues_) test_taken(queue);
  }

  void test_starts(Queue& queue) {
    if (queue.count == 0) return;
    triage_from(queue.packet, queue.elements[0].tipo, findings_);
    decide(queue);
  }
  void test_taken(Queue& queue) {
    if (queue.count == 0) return;
    triage(queue.packet, queue.elements[0].tipo, findings_);
    decide(queue);
  }

  /// The rays that have a bit against one element, eight by eight, but for those that start on it. A bit for each that
  /// it blocks. Whether it is one of several that a ray starts on is asked where the ray may meet it: most do not.
  std::uint64_t test_columns(const RayColumns& rays, std::span<const std::uint32_t> numbers, std::uint64_t which,
                             scene::ElementRef own) {
    if (some_start_) which &= ~starting_on(rays, which, own);
    if (which == 0) return 0;
    source_.visit(own, [&](const auto& shape) { triage(rays, which, shape, of_columns_); });
    std::uint64_t blocked = 0;
    for (std::uint64_t eights = eights_of(which); eights != 0; eights &= eights - 1) {
      const auto at = static_cast<std::size_t>(std::countr_zero(eights));
      const auto used = static_cast<unsigned>(which >> at & ((1u << Packet::size) - 1));
      const Findings& findings = of_columns_[at / Packet::size];
      for (unsigned left = (findings.hit | findings.undecided) & used; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        const std::uint32_t number = numbers[at + lane];
        if (!starts_on_it_too(number, own)) decide(findings, lane, number, own);
        blocked |= std::uint64_t{!open_[number]} << (at + lane);
      }
    }
    return blocked;
  }

  void decide(Queue& queue) {
    for (unsigned left = (findings_.hit | findings_.undecided) & ((1u << queue.count) - 1); left != 0;
         left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      const std::uint32_t number = queue.numbers[lane];
      if (open_[number]) decide(findings_, lane, number, queue.elements[lane]);
    }
    queue.count = 0;
  }

  /// Precondition: the lane is hit or undecided. The ends of where the parameter lies may be rounded
  /// (Certified::Point).
  void decide(const Findings& findings, std::size_t lane, std::uint32_t number, scene::ElementRef own) {
    const bool hit = (findings.hit >> lane & 1) != 0;
    if (hit && findings.t[lane] + findings.error[lane] < 1) {
      block(number);
    } else if (!(hit && findings.t[lane] - findings.error[lane] > 1)) {
      test(number, source_.element(own));
    }
  }

  const Source& source_;
  Picked<const scene::Query> queries_;
  Picked<bool> occluded_;
  std::vector<std::uint8_t> open_;  // not known to be occluded
  std::vector<Ray> rays_;
  bool some_start_ = false, some_start_untold_ = false;  // on an element, which the ray is told, or on some
  Queues starts_{}, queues_{};                           // of the elements that rays start on; of what was taken
  Findings findings_{};
  ColumnFindings of_columns_{};
};

/// occluded_segment_among of every query, in order, in lanes. Threads and precondition as of first_hits_among.
template <PairCandidates Source>
void occluded_segments_in_lanes(const Source& source, std::span<const scene::Query> queries, std::span<bool> occluded) {
  const std::vector<std::uint32_t> order = order_of(source, queries, Asked::segment);
  // In a larger scene company is farther off.
  const std::size_t most = std::clamp<std::size_t>(source.scene().size() / 8, 1 << 12, 1 << 16);
  const auto threads = static_cast<std::size_t>(oneapi::tbb::this_task_arena::max_concurrency());
  for_each_block(
      queries.size(),
      [&](std::size_t begin, std::size_t count) {
        SegmentBatch(source, picked(queries, order, begin, count), picked(occluded, order, begin, count)).answer();
      },
      most, 8 * threads);
}

}  // namespace durero::trace
