#pragma once
/// Batched answers over few elements. 64 rays stand in columns, and each element is tested for all of them side by
/// side. Some rays are left to be answered one by one: rays with numbers out of the ordinary, with several starts, with
/// an undecided element, or with two elements whose points are not told apart.

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "durero/scene/hit.hpp"
#include "durero/scene/query.hpp"
#include "durero/trace/candidates.hpp"
#include "durero/trace/certified.hpp"
#include "durero/trace/columns.hpp"
#include "durero/trace/segments.hpp"

namespace durero::trace {

/// A source whose elements every ray may meet, where all_leaves() names some: all of its elements then, none of which
/// is extraordinary.
template <class Source>
concept FewCandidates = PairCandidates<Source> && requires(const Source& source) {
  { source.all_leaves() } -> std::convertible_to<std::span<const scene::ElementRef>>;
};

/// Calls visit(place) for each bit.
template <class Visit>
void for_each_bit(std::uint64_t bits, Visit visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

/// Calls take(starts, findings, which, leaf) with the findings on each leaf for the rays of open() that do not start on
/// it, and then for those that do, until there are no such rays.
template <FewCandidates Source, class Open, class Visitor>
void test_all(const Source& source, const QueryColumns& columns, ColumnFindings& findings, Open open, Visitor take) {
  for (const scene::ElementRef leaf : source.all_leaves()) {
    const std::uint64_t which = open(), on = columns.starting_on(which, leaf), others = which & ~on;
    if (which == 0) return;
    source.visit(leaf, [&](const auto& shape) {
      if (others != 0) {
        triage(columns.rays, others, shape, findings);
        take(false, others, leaf);
      }
      if (on != 0) {
        triage_from(columns.rays, on, shape, findings);
        take(true, on, leaf);
      }
    });
  }
}

/// The first hits of a block of queries, in columns.
template <FewCandidates Source>
class ColumnBatch {
 public:
  /// The batch keeps references to its arguments, which must outlive it. Precondition: the source names its leaves.
  ColumnBatch(const Source& source, IndexedView<const scene::Query> queries, IndexedView<scene::Hit> hits)
      : source_(source), queries_(queries), hits_(hits), certified_(source.scene(), queries, hits, unseen_, false) {}

  /// Writes every answer.
  void answer() {
    for (std::size_t begin = 0; begin < queries_.size(); begin += RayColumns::size)
      answer(begin, std::min(RayColumns::size, queries_.size() - begin));
    certified_.finish();
  }

 private:
  void answer(std::size_t begin, std::size_t count) {
    std::uint64_t decided = columns_.take(source_, queries_, begin, count), on_start = 0;
    nearest_.clear();
    test_all(
        source_, columns_, findings_, [&] { return decided; },
        [&](bool starts, std::uint64_t which, scene::ElementRef leaf) {
          const KeptBits kept = keep_nearer(findings_, which, leaf, nearest_);
          on_start = starts ? on_start | kept.nearer : on_start & ~kept.nearer;
          decided &= ~kept.open;
        });
    for (std::size_t place = 0; place < count; ++place) {
      const auto number = static_cast<std::uint32_t>(begin + place);
      if ((decided >> place & 1) == 0)
        hits_[number] = first_hit_among(source_, queries_[number].rayo, queries_[number].en, unseen_);
      else if (nearest_.t[place] < no_limit)
        tell_hit(number, place, (on_start >> place & 1) != 0);
      else
        certified_.miss(number);
    }
  }

  void tell_hit(std::uint32_t number, std::size_t place, bool on_start) {
    const scene::ElementRef own = RayColumns::element(nearest_.own[place]);
    if (on_start)
      certified_.hit_own(number, columns_[place], source_.element(own), {nearest_[place]});
    else
      certified_.hit(number, columns_[place], source_, own, {nearest_[place]});
  }

  const Source& source_;
  IndexedView<const scene::Query> queries_;
  IndexedView<scene::Hit> hits_;
  Counts unseen_{};
  Certified certified_;
  QueryColumns columns_;
  NearestColumns nearest_;
  ColumnFindings findings_{};
};

/// Which segments of a block of queries are occluded, in columns.
template <FewCandidates Source>
class ColumnSegments {
 public:
  /// The batch keeps references to its arguments, which must outlive it. Precondition: the source names its leaves.
  ColumnSegments(const Source& source, IndexedView<const scene::Query> queries, IndexedView<bool> occluded)
      : source_(source), queries_(queries), occluded_(occluded) {}

  /// Writes every answer.
  void answer() {
    for (std::size_t begin = 0; begin < queries_.size(); begin += RayColumns::size)
      answer(begin, std::min(RayColumns::size, queries_.size() - begin));
  }

 private:
  void answer(std::size_t begin, std::size_t count) {
    const std::uint64_t taken = columns_.take(source_, queries_, begin, count);
    std::uint64_t free = taken;
    test_all(
        source_, columns_, findings_, [&] { return free; },
        [&](bool, std::uint64_t which, scene::ElementRef leaf) {
          const BlockedBits found = blocked_by(findings_, which);
          free &= ~found.blocked;
          for_each_bit(found.open, [&](std::size_t place) {
            if (blocks(begin + place, leaf)) free &= ~(std::uint64_t{1} << place);
          });
        });
    for (std::size_t place = 0; place < count; ++place) occluded_[begin + place] = (free >> place & 1) == 0;
    const std::uint64_t all = ~std::uint64_t{} >> (RayColumns::size - count);
    for_each_bit(all & ~taken, [&](std::size_t place) {
      const scene::Query& query = queries_[begin + place];
      occluded_[begin + place] = occluded_segment_among(source_, query.rayo, query.en, unseen_);
    });
  }

  bool blocks(std::size_t number, scene::ElementRef leaf) const {
    const scene::Query& query = queries_[number];
    return blocks_segment(source_.scene(), query, Ray(query.rayo), source_.element(leaf));
  }

  const Source& source_;
  IndexedView<const scene::Query> queries_;
  IndexedView<bool> occluded_;
  Counts unseen_{};
  QueryColumns columns_;
  ColumnFindings findings_{};
};

/// first_hits_among over few elements. Threads and preconditions are those of first_hits_among; the source names its
/// leaves.
template <FewCandidates Source>
void first_hits_in_columns(const Source& source, std::span<const scene::Query> queries, std::span<scene::Hit> hits) {
  for_each_block(queries.size(), [&](std::size_t begin, std::size_t count) {
    ColumnBatch(source, picked(queries, {}, begin, count), picked(hits, {}, begin, count)).answer();
  });
}

/// occluded_segment_among of every query, in order, over few elements, likewise.
template <FewCandidates Source>
void occluded_segments_in_columns(const Source& source, std::span<const scene::Query> queries,
                                  std::span<bool> occluded) {
  for_each_block(queries.size(), [&](std::size_t begin, std::size_t count) {
    ColumnSegments(source, picked(queries, {}, begin, count), picked(occluded, {}, begin, count)).answer();
  });
}

}  // namespace durero::trace
