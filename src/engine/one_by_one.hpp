#pragma once
/// An engine that answers each query by itself.

#include <tbb/parallel_for.h>

#include <memory>
#include <utility>

#include "durero/engine/engine.hpp"

namespace durero::engine {

/// Answers by first_hit(query) and occluded_segment(query). Precondition: any thread may call either.
template <class FirstHit, class OccludedSegment>
class OneByOne final : public Engine {
 public:
  OneByOne(FirstHit first_hit, OccludedSegment occluded_segment)
      : first_hit_(std::move(first_hit)), occluded_segment_(std::move(occluded_segment)) {}

  void first_hits(std::span<const scene::Query> queries, std::span<scene::Hit> hits) const override {
    tbb::parallel_for(std::size_t{0}, queries.size(), [&](std::size_t i) { hits[i] = first_hit_(queries[i]); });
  }
  void occluded_segments(std::span<const scene::Query> queries, std::span<bool> occluded) const override {
    tbb::parallel_for(std::size_t{0}, queries.size(),
                      [&](std::size_t i) { occluded[i] = occluded_segment_(queries[i]); });
  }

 private:
  FirstHit first_hit_;
  OccludedSegment occluded_segment_;
};

template <class FirstHit, class OccludedSegment>
std::unique_ptr<const Engine> one_by_one(FirstHit first_hit, OccludedSegment occluded_segment) {
  return std::make_unique<const OneByOne<FirstHit, OccludedSegment>>(std::move(first_hit), std::move(occluded_segment));
}

}  // namespace durero::engine
