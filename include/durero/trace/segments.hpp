#pragma once
/// Which of many segments are occluded: a block of rays at a time against a source of candidates, eight pairs of a ray
/// and an element at a time in lanes. As any point at t < 1 decides, nothing is rounded; what the triage leaves open is
/// asked of the search.

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/trace/candidates.hpp"
#include "durero/trace/packet.hpp"

namespace durero::trace {

/// Search::blocks_segment by the first step that can tell. Preconditions: the ray is that of the query, and ordinary;
/// the element is of the scene.
bool blocks_segment(const scene::Scene& scene, const scene::Query& query, const Ray& ray, scene::ElementRef e);

/// One block of rays against a source of candidates.
template <PairCandidates Source>
class SegmentBatch {
 public:
  /// All of these must outlive it. Precondition: a place in `occluded` for each query.
  SegmentBatch(const Source& source, std::span<const scene::Query> queries, std::span<bool> occluded)
      : source_(source), queries_(queries), occluded_(occluded), open_(queries.size(), true) {
    rays_.reserve(queries.size());
    for (const scene::Query& query : queries) rays_.emplace_back(query.rayo);
  }

  /// Writes every answer.
  void answer() {
    for (std::uint32_t number = 0; number < queries_.size(); ++number) begin(number);
    source_.pairs(
        rays_, [&](std::uint32_t number) { return open_[number] ? 1.0 : 0.0; },
        [&](std::uint32_t number, scene::ElementRef e) { take(number, e); }, [&] { flush(); });
    flush();
    for (const scene::ElementRef e : source_.extraordinary())
      for (std::uint32_t number = 0; number < queries_.size(); ++number)
        if (open_[number] && !starts_on(number, e)) test(number, e);
  }

 private:
  bool starts_on(std::uint32_t number, scene::ElementRef e) const { return Origin(queries_[number].en).contains(e); }

  /// Rays out of the ordinary are answered alone; the elements that a ray starts on, the source does not know of.
  void begin(std::uint32_t number) {
    const scene::Query& query = queries_[number];
    occluded_[number] = false;
    if (!rays_[number].ordinary) {
      Counts unseen;
      occluded_[number] = occluded_segment_among(source_, query.rayo, query.en, unseen);
      open_[number] = false;
      return;
    }
    for (const scene::ElementRef e : query.en)
      if (open_[number]) test(number, e);
  }

  void test(std::uint32_t number, scene::ElementRef e) {
    if (blocks_segment(source_.scene(), queries_[number], rays_[number], e)) block(number);
  }

  void block(std::uint32_t number) {
    occluded_[number] = true;
    open_[number] = false;
  }

  void take(std::uint32_t number, scene::ElementRef e) {
    if (!open_[number] || starts_on(number, e)) return;
    Queue& queue = queues_[static_cast<std::size_t>(e.tipo)];
    queue.push(source_.scene(), number, rays_[number], e);
    if (queue.full()) test(queue);
  }

  void flush() {
    for (Queue& queue : queues_) test(queue);
  }

  // The ends of where the parameter lies may be rounded (Certified::Point).
  void test(Queue& queue) {
    if (queue.count == 0) return;
    triage(queue.packet, queue.elements[0].tipo, findings_);
    for (unsigned left = (findings_.hit | findings_.undecided) & ((1u << queue.count) - 1); left != 0;
         left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      const std::uint32_t number = queue.numbers[lane];
      const bool hit = (findings_.hit >> lane & 1) != 0;
      if (hit && findings_.t[lane] + findings_.error[lane] < 1) {
        block(number);
      } else if (open_[number] && !(hit && findings_.t[lane] - findings_.error[lane] > 1)) {
        test(number, queue.elements[lane]);
      }
    }
    queue.count = 0;
  }

  const Source& source_;
  std::span<const scene::Query> queries_;
  std::span<bool> occluded_;
  std::vector<std::uint8_t> open_;  // not known to be occluded
  std::vector<Ray> rays_;
  Queues queues_{};
  Findings findings_{};
};

/// occluded_segment_among of every query, in order, in lanes. Threads and precondition as of first_hits_among.
template <PairCandidates Source>
void occluded_segments_in_lanes(const Source& source, std::span<const scene::Query> queries, std::span<bool> occluded) {
  for_each_block(queries.size(), [&](std::size_t begin, std::size_t count) {
    SegmentBatch(source, queries.subspan(begin, count), occluded.subspan(begin, count)).answer();
  });
}

}  // namespace durero::trace
