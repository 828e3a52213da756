#pragma once
/// A guided engine answers the rays of one path, each of which meets elements that are known beforehand.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/trace/counts.hpp"
#include "durero/trace/search.hpp"

namespace durero::render {

/// The elements that a ray meets first, and others that it may meet there after all. They outlive the path.
struct KnownMeeting {
  const scene::ElementSet& met;
  const scene::ElementSet& doubtful;
};

/// An engine for one thread. It searches nothing: it computes where a ray meets the elements that it is told of. Where
/// these are not met after all, since the rounded ray is not the exact one, and where it is told of none, it asks
/// another engine. Both, and the scene, must outlive it.
class GuidedEngine final : public engine::Engine {
 public:
  GuidedEngine(const scene::Scene& scene, const engine::Engine& other) : scene_(scene), other_(other) {}

  /// The elements that the rays of the next path meet, ray by ray; none where a ray meets nothing.
  void guide(std::vector<KnownMeeting> meetings) {
    meetings_ = std::move(meetings);
    step_ = 0;
  }

  /// The number of rays that the other engine was asked.
  std::uint64_t asked() const noexcept { return asked_; }

  void first_hits(std::span<const scene::Query> queries, std::span<scene::Hit> hits) const override {
    for (std::size_t i = 0; i < queries.size(); ++i) hits[i] = first(queries[i]);
  }
  void first_elements(std::span<const scene::Query> queries, std::span<trace::FirstElement> elements) const override {
    other_.first_elements(queries, elements);
  }
  void occluded_segments(std::span<const scene::Query> queries, std::span<bool> occluded) const override {
    other_.occluded_segments(queries, occluded);
  }
  glm::dvec3 normal(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point) const override {
    return other_.normal(scene, element, point);
  }

 private:
  scene::Hit first(const scene::Query& query) const {
    if (step_ < meetings_.size()) {
      const auto& [met, doubtful] = meetings_[step_++];
      trace::Counts counts;
      trace::Search search(scene_, query.rayo, query.en, counts);
      for (const scene::ElementRef e : met) search.test(e);
      for (const scene::ElementRef e : doubtful) search.test(e);
      scene::Hit hit = search.finish();
      if (hit.elementos == met) return hit;
    }
    ++asked_;
    return engine::first_hit(other_, query);
  }

  const scene::Scene& scene_;
  const engine::Engine& other_;
  std::vector<KnownMeeting> meetings_{};
  mutable std::size_t step_ = 0;  // an engine's answers are const; the steps are of one path, on one thread
  mutable std::uint64_t asked_ = 0;
};

}  // namespace durero::render
