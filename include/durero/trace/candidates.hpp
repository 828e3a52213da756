#pragma once
/// Certified answers over a source of candidates. An acceleration structure is such a source: it says which elements a
/// ray may meet, and the search decides. The answers are those of surface::exact, byte for byte, for every source that
/// passes over no element that the ray meets.

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "durero/scene/hit.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "durero/surface/exact.hpp"
#include "durero/trace/batch.hpp"
#include "durero/trace/bundled.hpp"
#include "durero/trace/certified.hpp"
#include "durero/trace/found_hits.hpp"
#include "durero/trace/search.hpp"

namespace durero::trace {

/// A source of candidates divides the elements of its scene into the extraordinary, which every ray may meet, and the
/// others, which it passes over only for rays that miss them. It offers
///   scene()           the scene, unedited since the source was made;
///   extraordinary()   the elements that are not `ordinary`, perhaps with others;
///   any(ray, limit, visit)
///                     visit(e) for each other element that the ray may meet at 0 < t ≤ limit(), at most once each,
///                     until visit answers true. The result is whether it did. The limit may fall between visits.
/// Precondition of any: the ray is ordinary.
template <class Source>
concept Candidates =
    requires(const Source& source, const Ray& ray, double (&limit)(), bool (&visit)(scene::ElementRef)) {
      { source.scene() } -> std::convertible_to<const scene::Scene&>;
      { source.extraordinary() } -> std::convertible_to<std::span<const scene::ElementRef>>;
      { source.any(ray, limit, visit) } -> std::same_as<bool>;
    };

/// A source that serves many rays at once, and may name elements in its own way:
///   pairs(rays, limit, take, flush)
///                     take(number, own) for each visit that any would make, with the ray's number in `rays`. A ray
///                     whose limit(number) is 0 is passed over. After flush() the limits reflect every take so far.
///   visit(own, f)     f(shape) with the geometry of a named element;
///   element(own)      the element of the scene with that name, which has the same type;
///   own(e)            the source's name of an element that is not in extraordinary(): element(own(e)) = e;
///   ask_for_own(e)    prefetches the memory that own(e) reads;
///   ask_for_shape(own)
///                     prefetches the memory that visit(own, f) reads.
/// Precondition of pairs: rays whose limit is not 0 are ordinary.
template <class Source>
concept PairCandidates =
    Candidates<Source> &&
    requires(const Source& source, std::span<const Ray> rays, double (&limit_of)(std::uint32_t),
             void (&take)(std::uint32_t, scene::ElementRef), void (&flush)(), scene::ElementRef own) {
      source.pairs(rays, limit_of, take, flush);
      source.visit(own, [](const auto&) {});
      { source.element(own) } -> std::same_as<scene::ElementRef>;
      { source.own(own) } -> std::same_as<scene::ElementRef>;
      source.ask_for_own(own);
      source.ask_for_shape(own);
    };

/// Calls visit(e, range) for every element of the scene, until it answers true. Whether it did.
template <class Visit>
bool any_element(const scene::Scene& scene, Visit visit) {
  return scene.any_of([&](scene::ElementRef e, const auto&) { return visit(e, Search::Range::unknown); });
}

/// Calls visit(e, range) for every element that the ray may meet at t ≤ limit(), until it answers true. Whether it did.
/// Elements that the ray starts on are visited first and are not left to the source, which does not know of the start.
template <Candidates Source, class Limit, class Visit>
bool any_candidate(const Source& source, const Ray& ray, Origin en, Limit limit, Visit visit) {
  using Range = Search::Range;
  if (!ray.ordinary) return any_element(source.scene(), visit);
  for (const scene::ElementRef e : en) {
    if (visit(e, Range::unknown)) return true;
  }
  const auto visit_other = [&](scene::ElementRef e, Range range) { return !en.contains(e) && visit(e, range); };
  if (source.any(ray, limit, [&](scene::ElementRef e) { return visit_other(e, Range::ordinary); })) return true;
  for (const scene::ElementRef e : source.extraordinary()) {
    if (visit_other(e, Range::unknown)) return true;
  }
  return false;
}

/// The first hit among the elements that walk(visit) visits.
template <class Walk>
scene::Hit first_hit_of(Search& search, Walk walk) {
  walk([&](scene::ElementRef e, Search::Range range) {
    search.test(e, range);
    return false;
  });
  return search.finish();
}

/// Primera_Interseccion over a source of candidates. Precondition of this and the functions below: the elements of en
/// are in the scene.
template <Candidates Source>
scene::Hit first_hit_among(const Source& source, const model::Rayo& rayo, Origin en, Counts& counts) {
  Search search(source.scene(), rayo, en, counts);
  const auto limit = [&] { return search.limit(); };
  return first_hit_of(search, [&](auto visit) { any_candidate(source, search.ray(), en, limit, visit); });
}

/// Whether the ray meets some element at some t > 0.
template <Candidates Source>
bool occluded_among(const Source& source, const model::Rayo& rayo, Origin en, Counts& counts) {
  const Search search(source.scene(), rayo, en, counts);
  const auto limit = [] { return no_limit; };
  return any_candidate(source, search.ray(), en, limit,
                       [&](scene::ElementRef e, Search::Range range) { return search.blocks(e, range); });
}

/// Whether the ray meets some element at some 0 < t < 1.
template <Candidates Source>
bool occluded_segment_among(const Source& source, const model::Rayo& rayo, Origin en, Counts& counts) {
  const Search search(source.scene(), rayo, en, counts);
  const auto limit = [] { return 1.0; };
  return any_candidate(source, search.ray(), en, limit,
                       [&](scene::ElementRef e, Search::Range range) { return search.blocks_segment(e, range); });
}

/// surface::exact::points_between over a source of candidates.
template <Candidates Source>
std::optional<std::vector<surface::exact::ElementPoint>> points_between_among(const Source& source,
                                                                              const scene::Query& query,
                                                                              surface::exact::RayStretch stretch,
                                                                              const surface::exact::Passes& passes) {
  const bool whole = stretch == surface::exact::RayStretch::whole;
  Counts unseen;
  const Search search(source.scene(), query.rayo, query.en, unseen);
  scene::ElementSet met;
  const auto limit = [&] { return whole ? no_limit : 1.0; };
  const bool is_dark =
      any_candidate(source, search.ray(), query.en, limit, [&](scene::ElementRef e, Search::Range range) {
        if (!(whole ? search.blocks(e, range) : search.blocks_segment(e, range))) return false;
        met.push_back(e);
        return !passes(e);
      });
  if (is_dark) return std::nullopt;
  return surface::exact::points_of(source.scene(), std::move(met), query.rayo, query.en, stretch);
}

/// Calls answer(begin, count) for blocks that make up `size` queries, on as many threads as the calling thread may use.
/// The size of a block grows with the number of queries, because a larger block holds more coherent rays: from 256 to
/// `most`, and to a `not_fewer`-th of the queries, which leaves several blocks to each thread. A free thread takes the
/// next block, so that none waits long for another at the end. A thread that may use no other takes `most` at once.
template <class Answer>
void for_each_block(std::size_t size, Answer answer, std::size_t most = 4096, std::size_t not_fewer = 64) {
  const bool is_alone = oneapi::tbb::this_task_arena::max_concurrency() == 1;
  const std::size_t block_size = is_alone ? most : std::clamp<std::size_t>(size / not_fewer, 256, most);
  const std::size_t blocks = (size + block_size - 1) / block_size;
  const auto answer_block = [&](std::size_t block) {
    const std::size_t begin = block * block_size;
    answer(begin, std::min(block_size, size - begin));
  };
  if (blocks == 1) return answer_block(0);
  oneapi::tbb::parallel_for(std::size_t{0}, blocks, answer_block, oneapi::tbb::simple_partitioner());
}

/// first_hit_among of some queries, batched in lanes. `of_pairs` says whether the tested pairs are counted.
template <PairCandidates Source>
void first_hits_in_lanes(const Source& source, IndexedView<const scene::Query> queries, IndexedView<scene::Hit> hits,
                         Counts& counts, bool of_pairs) {
  Certified certified(source.scene(), queries, hits, counts, of_pairs);
  Batch batch(source, queries, certified);
  batch.answer();
  certified.finish();
  batch.for_each_alone([&](std::uint32_t number) {
    hits[number] = first_hit_among(source, queries[number].rayo, queries[number].en, counts);
  });
  counts.element[0] += batch.decided();
}

/// The queries of a block whose first hits are not found in bundles; the others have theirs.
template <PairCandidates Source>
Unbundled without_bundled_hits(const Source& source, IndexedView<const scene::Query> queries,
                               IndexedView<scene::Hit> hits) {
  FoundHits found(source.scene(), queries, hits);
  // The bundle's type is open, so that nothing is compiled for a source without blocks.
  return Unbundled(
      source, queries, SingleSearch::nearest,
      [&](std::uint32_t first, const auto& rays, std::uint64_t which) { found.answer(first, rays, which, source); });
}

/// first_hit_among of every query, in order, batched in lanes: for more than a few rays the fastest way to the same
/// bytes. The result does not depend on the number of threads. `counts`, where given, is added to, and no ray is then
/// answered in a bundle, which has no pairs to count. Precondition: `hits` has a place for each query.
template <PairCandidates Source>
void first_hits_among(const Source& source, std::span<const scene::Query> queries, std::span<scene::Hit> hits,
                      Counts* counts) {
  std::mutex adding;
  const std::vector<std::uint32_t> order = order_of(source, queries, QueryKind::first);
  for_each_block(queries.size(), [&](std::size_t begin, std::size_t count) {
    Counts of_block;
    const auto block = picked(queries, order, begin, count);
    const auto answers = picked(hits, order, begin, count);
    if (counts == nullptr) {
      const Unbundled left = without_bundled_hits(source, block, answers);
      if (!left.none()) first_hits_in_lanes(source, left.of(block), left.of(answers), of_block, false);
      return;
    }
    first_hits_in_lanes(source, block, answers, of_block, true);
    const std::scoped_lock lock(adding);
    *counts += of_block;
  });
}

/// occluded_segment_among of every query, in order. Threads and precondition are those of first_hits_among.
template <Candidates Source>
void occluded_segments_among(const Source& source, std::span<const scene::Query> queries, std::span<bool> occluded) {
  for_each_block(queries.size(), [&](std::size_t begin, std::size_t count) {
    Counts unseen;
    for (std::size_t i = begin; i < begin + count; ++i) {
      occluded[i] = occluded_segment_among(source, queries[i].rayo, queries[i].en, unseen);
    }
  });
}

}  // namespace durero::trace
