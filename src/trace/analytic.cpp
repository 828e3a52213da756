#include "durero/trace/analytic.hpp"

#include "durero/trace/candidates.hpp"

namespace durero::trace {

scene::Hit first_hit(const Tables& tables, const model::Rayo& rayo, Origin en, Counts* counts) {
  Counts unseen;
  return first_hit_among(tables, rayo, en, counts ? *counts : unseen);
}

bool occluded(const Tables& tables, const model::Rayo& rayo, Origin en, Counts* counts) {
  Counts unseen;
  return occluded_among(tables, rayo, en, counts ? *counts : unseen);
}

bool occluded_segment(const Tables& tables, const model::Rayo& rayo, Origin en, Counts* counts) {
  Counts unseen;
  return occluded_segment_among(tables, rayo, en, counts ? *counts : unseen);
}

void first_hits(const Tables& tables, std::span<const scene::Query> queries, std::span<scene::Hit> hits,
                Counts* counts) {
  first_hits_among(tables, queries, hits, counts);
}

std::vector<scene::Hit> first_hits(const Tables& tables, std::span<const scene::Query> queries, Counts* counts) {
  std::vector<scene::Hit> hits(queries.size());
  first_hits(tables, queries, hits, counts);
  return hits;
}

void occluded_segments(const Tables& tables, std::span<const scene::Query> queries, std::span<bool> occluded) {
  occluded_segments_among(tables, queries, occluded);
}

scene::Hit first_hit(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  Counts unseen;
  Search search(scene, rayo, en, unseen);
  return first_hit_of(search, [&](auto visit) { any_element(scene, visit); });
}

bool occluded(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  Counts unseen;
  const Search search(scene, rayo, en, unseen);
  return any_element(scene, [&](scene::ElementRef e, Search::Range range) { return search.blocks(e, range); });
}

bool occluded_segment(const scene::Scene& scene, const model::Rayo& rayo, Origin en) {
  Counts unseen;
  const Search search(scene, rayo, en, unseen);
  return any_element(scene, [&](scene::ElementRef e, Search::Range range) { return search.blocks_segment(e, range); });
}

}  // namespace durero::trace
