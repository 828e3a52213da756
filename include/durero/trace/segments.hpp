#pragma once
/// Which of many segments are occluded: a block of rays at a time against a source of candidates, eight pairs of a ray
/// and an element at a time in lanes. As any point at t < 1 decides, nothing is rounded; what the triage leaves open is
/// asked of the search.

#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
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
      : source_(source), queries_(queries), occluded_(occluded), open_(queries.size(), true), start_(queries.size()) {
    rays_ = rays_of(queries, [&](std::size_t i, const scene::Query& query, const Ray&) {
      if (!query.en.empty()) start_[i] = {query.en[0], query.en.size() > 1};
    });
  }

  /// Writes every answer.
  void answer() {
    constexpr std::uint32_t ahead = 24;
    for (std::uint32_t number = 0; number < queries_.size(); ++number) {
      if (number + ahead < queries_.size()) ask_for_start(start_[number + ahead]);
      begin(number);
    }
    for (Queue& queue : starts_) test_starts(queue);
    source_.pairs(
        rays_, [&](std::uint32_t number) { return open_[number] ? 1.0 : 0.0; }, Take{*this}, [&] { flush(); });
    flush();
    for (const scene::ElementRef e : source_.extraordinary())
      for (std::uint32_t number = 0; number < queries_.size(); ++number)
        if (open_[number] && !starts_on(number, e)) test(number, e);
  }

 private:
  static constexpr scene::ElementRef no_element{{}, std::numeric_limits<std::uint32_t>::max()};

  /// What a ray starts on: mostly one element, which is at hand.
  struct Start {
    scene::ElementRef first = no_element;
    bool more = false;  // the others are asked of the query
  };
  bool starts_on(std::uint32_t number, scene::ElementRef e) const {
    const Start& start = start_[number];
    return start.first == e || (start.more && Origin(queries_[number].en).contains(e));
  }

  void ask_for_start(const Start& start) const {
    if (start.first == no_element) return;
    source_.scene().visit(start.first, [](const auto& shape) { ask_for(shape); });
  }

  /// Rays out of the ordinary are answered alone; the elements that a ray starts on, the source does not know of.
  void begin(std::uint32_t number) {
    occluded_[number] = false;
    if (!rays_[number].ordinary) {
      const scene::Query& query = queries_[number];
      Counts unseen;
      occluded_[number] = occluded_segment_among(source_, query.rayo, query.en, unseen);
      open_[number] = false;
    } else if (start_[number].more) {
      for (const scene::ElementRef e : queries_[number].en) begin_on(number, e);
    } else if (start_[number].first != no_element) {
      begin_on(number, start_[number].first);
    }
  }

  /// In lanes where the element is ordinary: all are where none is known to be extraordinary.
  void begin_on(std::uint32_t number, scene::ElementRef e) {
    if (!open_[number]) return;
    if (!source_.extraordinary().empty()) return test(number, e);
    Queue& queue = starts_[static_cast<std::size_t>(e.tipo)];
    queue.push(source_.scene(), number, rays_[number], e);
    if (queue.full()) test_starts(queue);
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
    void operator()(std::uint32_t number, scene::ElementRef own) const { batch.take(number, own); }
    template <class Numbers>
    std::uint64_t operator()(const RayColumns& rays, const Numbers& numbers, std::uint64_t which,
                             scene::ElementRef own) const {
      return batch.test_columns(rays, numbers, which, own);
    }
  };

  void take(std::uint32_t number, scene::ElementRef own) {
    if (!open_[number]) return;
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
    decide(queue, [&](std::uint32_t, scene::ElementRef e) { return std::optional(e); });
  }

  /// What a ray starts on is known already; that it was tested as if it did not means nothing.
  void test_taken(Queue& queue) {
    if (queue.count == 0) return;
    triage(queue.packet, queue.elements[0].tipo, findings_);
    decide(queue, [&](std::uint32_t number, scene::ElementRef own) {
      const scene::ElementRef e = source_.element(own);
      return starts_on(number, e) ? std::nullopt : std::optional(e);
    });
  }

  /// The rays that have a bit against one element, eight by eight. A bit for each that it blocks. Which element of the
  /// scene it is, is asked where some ray may meet it: most do not.
  std::uint64_t test_columns(const RayColumns& rays, std::span<const std::uint32_t> numbers, std::uint64_t which,
                             scene::ElementRef own) {
    source_.visit(own, [&](const auto& shape) { triage(rays, which, shape, of_columns_); });
    std::uint64_t blocked = 0;
    for (std::size_t at = 0; at < RayColumns::size; at += Packet::size) {
      const auto used = static_cast<unsigned>(which >> at & ((1u << Packet::size) - 1));
      if (used == 0) continue;
      const Findings& findings = of_columns_[at / Packet::size];
      for (unsigned left = (findings.hit | findings.undecided) & used; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        const std::uint32_t number = numbers[at + lane];
        const scene::ElementRef e = source_.element(own);
        if (!starts_on(number, e)) decide(findings, lane, number, e);
        blocked |= std::uint64_t{!open_[number]} << (at + lane);
      }
    }
    return blocked;
  }

  /// Of what the findings do not exclude, element(number, name) says which one it is, or nothing where it does not
  /// count.
  template <class Element>
  void decide(Queue& queue, Element element) {
    for (unsigned left = (findings_.hit | findings_.undecided) & ((1u << queue.count) - 1); left != 0;
         left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      const std::uint32_t number = queue.numbers[lane];
      if (!open_[number]) continue;
      const std::optional<scene::ElementRef> e = element(number, queue.elements[lane]);
      if (e) decide(findings_, lane, number, *e);
    }
    queue.count = 0;
  }

  /// Precondition: the lane is hit or undecided. The ends of where the parameter lies may be rounded
  /// (Certified::Point).
  void decide(const Findings& findings, std::size_t lane, std::uint32_t number, scene::ElementRef e) {
    const bool hit = (findings.hit >> lane & 1) != 0;
    if (hit && findings.t[lane] + findings.error[lane] < 1) {
      block(number);
    } else if (!(hit && findings.t[lane] - findings.error[lane] > 1)) {
      test(number, e);
    }
  }

  const Source& source_;
  Picked<const scene::Query> queries_;
  Picked<bool> occluded_;
  std::vector<std::uint8_t> open_;  // not known to be occluded
  std::vector<Ray> rays_;
  std::vector<Start> start_;
  Queues starts_{}, queues_{};  // of the elements that rays start on, by the scene's names; of what was taken
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
