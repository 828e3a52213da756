#pragma once
/// An engine over an acceleration structure. Candidates come from the structure, answers from the certified search.

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

#include "durero/accel/hierarchy.hpp"
#include "durero/accel/structure.hpp"
#include "durero/engine/engine.hpp"

namespace durero::engine {

/// Answers each query by itself, in blocks that threads share.
template <accel::Structure S>
class Structured final : public Engine {
 public:
  /// Makes the structure of the scene and `more`.
  template <class... More>
  explicit Structured(const scene::Scene& scene, const More&... more) : structure_(scene, more...) {}

  void first_hits(std::span<const scene::Query> queries, std::span<scene::Hit> hits) const override {
    trace::for_each_block(queries.size(), [&](std::size_t begin, std::size_t count) {
      trace::Counts unseen;
      for (std::size_t i = begin; i < begin + count; ++i)
        hits[i] = trace::first_hit_among(accel::CandidateSource(structure_), queries[i].rayo, queries[i].en, unseen);
    });
  }
  void occluded_segments(std::span<const scene::Query> queries, std::span<bool> occluded) const override {
    trace::occluded_segments_among(accel::CandidateSource(structure_), queries, occluded);
  }
  std::optional<std::vector<surface::exact::ElementPoint>> points_between(
      const scene::Scene&, const scene::Query& query, surface::exact::RayStretch stretch,
      const surface::exact::Passes& passes) const override {
    return trace::points_between_among(accel::CandidateSource(structure_), query, stretch, passes);
  }

 private:
  S structure_;
};

template <accel::Structure S, class... More>
std::unique_ptr<const Engine> structured(const scene::Scene& scene, const More&... more) {
  return std::make_unique<const Structured<S>>(scene, more...);
}

/// The time of a call.
template <class Do>
double seconds_of(Do what) {
  const auto start = std::chrono::steady_clock::now();
  what();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The branching of a hierarchy. Precondition: it has an inner node.
inline Branching branching(const accel::Hierarchy& tree) {
  Branching found{accel::weight<double>(tree) / accel::area<double>(tree[tree.root()].box), 0, 0};
  std::size_t inner = 0, children = 0;
  tree.for_each([&](const accel::Hierarchy::Node& node) {
    if (node.is_leaf()) return;
    ++inner;
    children += node.arity;
    found.most = std::max<std::size_t>(found.most, node.arity);
  });
  found.arity = static_cast<double>(children) / static_cast<double>(inner);
  return found;
}

/// EngineRow::measure. The timed rays are not counted, because counting takes time.
template <accel::Structure S, class... More>
Figures measured(const scene::Scene& scene, std::span<const scene::Query> queries, const More&... more) {
  trace::Counts unseen;
  Figures figures{};
  std::optional<S> made;
  figures.building_seconds = seconds_of([&] { made.emplace(scene, more...); });
  const S& structure = *made;
  figures.answering_seconds = seconds_of([&] {
    for (const scene::Query& query : queries)
      trace::first_hit_among(accel::CandidateSource(structure), query.rayo, query.en, unseen);
  });
  const accel::Counted counted(structure, figures.work);
  for (const scene::Query& query : queries) trace::first_hit_among(counted, query.rayo, query.en, unseen);
  figures.size = structure.size();  // at the end, because some structures are built on demand
  if constexpr (requires { structure.hierarchy(); })
    if (figures.size.nodes > 0) figures.branching = branching(structure.hierarchy());
  return figures;
}

}  // namespace durero::engine
