#pragma once
/// Many rays at once against the same rays one by one.

#include <boost/container/vector.hpp>
#include <span>
#include <vector>

#include "durero/accel/wide/wide_bvh.hpp"
#include "durero/trace/first_element.hpp"
#include "durero/trace/segments.hpp"
#include "support/catch.hpp"

namespace durero::test {

/// First hits, first elements and segments of many rays are what each ray gets alone, in its place.
inline void check_each_alone(const accel::WideBvh& tree, std::span<const scene::Query> queries) {
  std::vector<scene::Hit> hits(queries.size());
  std::vector<trace::FirstElement> elements(queries.size());
  boost::container::vector<bool> occluded(queries.size());
  trace::first_hits_among(tree, queries, hits, nullptr);
  trace::first_elements_among(tree, queries, elements);
  trace::occluded_segments_in_lanes(tree, queries, {occluded.data(), occluded.size()});
  trace::Counts unseen;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const scene::Query& query = queries[i];
    const scene::Hit hit = trace::first_hit_among(tree, query.rayo, query.en, unseen);
    CHECK(hits[i] == hit);
    CHECK(elements[i] == trace::first_element(hit));
    CHECK(occluded[i] == trace::occluded_segment_among(tree, query.rayo, query.en, unseen));
  }
}

}  // namespace durero::test
