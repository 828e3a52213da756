#pragma once
/// Batched any-hit search: which of a block of segments are occluded, with eight pairs of a ray and an element tested
/// side by side in lanes. Nothing is rounded, because any point at t < 1 decides. The search of one ray decides what
/// the triage leaves open.

#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/trace/candidates.hpp"
#include "durero/trace/packet.hpp"
#include "durero/trace/picked.hpp"
#include "durero/trace/single_rays.hpp"

namespace durero::trace {

/// Search::blocks_segment by the first step that can tell. Preconditions: the ray is that of the query, and ordinary;
/// the element is in the scene.
bool blocks_segment(const scene::Scene& scene, const scene::Query& query, const Ray& ray, scene::ElementRef e);

/// A block of segments and a source of candidates.
template <PairCandidates Source>
class SegmentBatch {
 public:
  /// The batch keeps references to its arguments, which must outlive it. Precondition: `occluded` has a place for each
  /// query.
  SegmentBatch(const Source& source, IndexedView<const scene::Query> queries, IndexedView<bool> occluded)
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
        rays_, [&](std::uint32_t number) { return open_[number] ? 1.0 : 0.0; }, Visitor{*this}, [&] { flush(); });
    flush();
    for (const scene::ElementRef e : source_.extraordinary())
      for (std::uint32_t number = 0; number < queries_.size(); ++number)
        if (open_[number] && !Origin(queries_[number].en).contains(e)) test(number, e);
  }

 private:
  /// The distance in rays at which a start element is prefetched. A ray begins in about 7 ns, and memory answers within
  /// 160 ns. Among 10⁶ elements the prefetch saves 3 % of the time of shadow rays, at any distance from 4 to 64.
  static constexpr std::size_t ahead = 24;
  static constexpr std::size_t large = 1 << 12;  // elements that the nearer caches do not hold

  /// Tests a ray against the elements that it starts on, which are not left to the source, or a run of consecutive rays
  /// that are known to start on the same element. The number of the next ray.
  std::uint32_t begin(std::uint32_t number) {
    const scene::ElementRef start = rays_[number].start();
    std::uint32_t end = number;
    do {
      occluded_[end] = false;
      if (is_large_) ask_for_start(end + ahead);
    } while (++end < rays_.size() && start != nothing && rays_[end].start() == start);
    if (start != nothing) {
      begin_on(start, number, end);
    } else {
      begin_alone(number);
    }
    return end;
  }

  /// Prefetches the element that a ray starts on, unless the ray before it starts on the same.
  void ask_for_start(std::size_t number) const {
    if (number >= rays_.size()) return;
    const scene::ElementRef start = rays_[number].start();
    if (start != nothing && start != rays_[number - 1].start()) source_.ask_for_shape(start);
  }

  /// Queues the rays begin … end against the ordinary element that they start on, for the lanes.
  void begin_on(scene::ElementRef own, std::uint32_t begin, std::uint32_t end) {
    Queue& queue = starts_[static_cast<std::size_t>(own.tipo)];
    for (std::span<const Ray> left = std::span(rays_).subspan(begin, end - begin); !left.empty();) {
      const auto number = static_cast<std::uint32_t>(end - left.size());
      left = left.subspan(queue.push(source_, number, left, own));
      if (queue.full()) test_starts(queue);
    }
  }

  /// Tests a ray against the elements that it starts on. A ray with numbers out of the ordinary is answered at once.
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

  /// Whether `own` is one of several elements that the ray starts on. Precondition: it is not ray.start().
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

  /// The `take` of PairCandidates::pairs. A ray's limit stays 1 until it is occluded, as any-hit traversal requires.
  struct Visitor {
    static constexpr bool any_hit = true;
    SegmentBatch& batch;
    bool starts() const { return batch.some_start_; }
    void operator()(std::uint32_t number, scene::ElementRef own) const { batch.take(number, own); }
    void operator()(std::uint32_t number, const TriangleBlock& block, scene::ElementRef first) const {
      batch.take(number, block, first);
    }
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

  /// Tests a segment against a block of triangles, the first of which has the name `first`.
  void take(std::uint32_t number, const TriangleBlock& block, scene::ElementRef first) {
    if (!open_[number]) return;
    const bool single = of_single_ && in_single_range(rays_[number]);
    if (single && possible_hits(rays_[number], block, 1) == 0) return;
    triage(rays_[number], block, findings_);
    const unsigned others = ~lane_of(rays_[number].start(), first);  // than the triangle that the ray starts on
    for (unsigned left = (findings_.hit | findings_.undecided) & others; left != 0 && open_[number]; left &= left - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(left));
      const scene::ElementRef own{first.tipo, first.index + lane};
      if (!starts_on_it_too(number, own)) decide(findings_, lane, number, own);
    }
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

  /// Tests an element for the rays in `which`, in groups of eight, without the rays whose start() it is. The answer has
  /// a bit for each ray that is occluded now. A ray that starts on several elements is checked only where the triage
  /// finds a hit or doubt, because most rays miss.
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

  /// Decides a ray by the findings of a lane, or by the search where they do not tell. Precondition: the lane is hit or
  /// undecided. The roundings of t ± error are covered (Certified::Point).
  void decide(const Findings& findings, std::size_t lane, std::uint32_t number, scene::ElementRef own) {
    const bool hit = (findings.hit >> lane & 1) != 0;
    if (hit && findings.t[lane] + findings.error[lane] < 1) {
      block(number);
    } else if (!(hit && findings.t[lane] - findings.error[lane] > 1)) {
      test(number, source_.element(own));
    }
  }

  const Source& source_;
  IndexedView<const scene::Query> queries_;
  IndexedView<bool> occluded_;
  bool is_large_ = source_.scene().size() > large;  // so that elements are prefetched
  std::vector<std::uint8_t> open_;                  // the ray is not known to be occluded
  std::vector<Ray> rays_;
  const bool of_single_ = has_single_blocks(source_);    // the test in binary32 serves
  bool some_start_ = false, some_start_untold_ = false;  // some ray starts on ray.start(); some ray starts without it
  Queues starts_{}, queues_{};                           // of the elements that rays start on; of candidates
  Findings findings_{};
  ColumnFindings of_columns_{};
};

/// occluded_segment_among of every query, in order, batched in lanes. Threads and precondition are those of
/// first_hits_among.
template <PairCandidates Source>
void occluded_segments_in_lanes(const Source& source, std::span<const scene::Query> queries, std::span<bool> occluded) {
  const std::vector<std::uint32_t> order = order_of(source, queries, QueryKind::segment);
  // A larger scene needs larger blocks for as many coherent segments.
  const std::size_t most = std::clamp<std::size_t>(source.scene().size() / 8, 1 << 12, 1 << 16);
  const auto threads = static_cast<std::size_t>(oneapi::tbb::this_task_arena::max_concurrency());
  for_each_block(
      queries.size(),
      [&](std::size_t begin, std::size_t count) {
        const auto block = picked(queries, order, begin, count);
        const auto answers = picked(occluded, order, begin, count);
        const Unbundled left(source, block, SingleSearch::any,
                             [&](std::uint32_t first, const SingleRays& rays, std::uint64_t which) {
                               for (; which != 0; which &= which - 1) {
                                 const auto place = static_cast<std::size_t>(std::countr_zero(which));
                                 answers[first + place] = rays.meets(place);
                               }
                             });
        if (!left.none()) SegmentBatch(source, left.of(block), left.of(answers)).answer();
      },
      most, 8 * threads);
}

}  // namespace durero::trace
