#pragma once
/// The engine `fast` answers rays in batches over the wide hierarchy.

#include "durero/accel/wide/wide_bvh.hpp"
#include "durero/engine/engine.hpp"
#include "durero/trace/few.hpp"
#include "durero/trace/first_element.hpp"
#include "durero/trace/segments.hpp"

namespace durero::engine {

class Fast final : public Engine {
 public:
  explicit Fast(const scene::Scene& scene) : tree_(scene) {}

  void first_hits(std::span<const scene::Query> queries, std::span<scene::Hit> hits) const override {
    if (tree_.all_leaves().empty())
      trace::first_hits_among(tree_, queries, hits, nullptr);
    else
      trace::first_hits_in_columns(tree_, queries, hits);
  }
  void first_elements(std::span<const scene::Query> queries, std::span<trace::FirstElement> elements) const override {
    trace::first_elements_among(tree_, queries, elements);
  }
  void occluded_segments(std::span<const scene::Query> queries, std::span<bool> occluded) const override {
    if (tree_.all_leaves().empty())
      trace::occluded_segments_in_lanes(tree_, queries, occluded);
    else
      trace::occluded_segments_in_columns(tree_, queries, occluded);
  }
  std::optional<std::vector<surface::exact::ElementPoint>> points_between(
      const scene::Scene&, const scene::Query& query, surface::exact::RayStretch stretch,
      const surface::exact::Passes& passes) const override {
    return trace::points_between_among(tree_, query, stretch, passes);
  }

 private:
  accel::WideBvh tree_;
};

}  // namespace durero::engine
