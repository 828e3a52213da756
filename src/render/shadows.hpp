#pragma once
/// Colours that wait for the answer whether a light is seen.

#include <boost/container/vector.hpp>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/render/whitted.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {

/// What waits for lights of one kind. An engine is asked light by light, since neighbours have like ways to one light;
/// colours are added in the order in which they came.
class AskedLights {
 public:
  explicit AskedLights(std::size_t lights) : queries_(lights), unseen_(lights) {}

  /// The colour of a ray waits for a light, by its number: whether it is seen from the point of a hit.
  void add(std::size_t light, std::uint32_t ray, const glm::dvec3& color, const scene::Hit& from,
           const glm::dvec3& to_light) {
    if (color == glm::dvec3(0)) return;
    waiting_.push_back({ray, static_cast<std::uint32_t>(light), queries_[light].size(), color});
    queries_[light].emplace_back(model::Rayo(model::Punto(from.punto), model::Vector(to_light)), from.elementos);
  }

  /// Adds each colour to that of its ray where its light is seen, and nothing waits any more: unseen(queries, answers)
  /// says of which it is not.
  template <class Unseen>
  void add_seen(std::span<Brought> sums, Unseen&& unseen) {
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      unseen_[i].resize(queries_[i].size());
      unseen(std::span<const scene::Query>(queries_[i]), std::span<bool>(unseen_[i].data(), unseen_[i].size()));
      queries_[i].clear();
    }
    for (const Waiting& one : waiting_)
      if (!unseen_[one.light][one.place]) sums[one.ray].color += one.color;
    waiting_.clear();
  }

 private:
  struct Waiting {
    std::uint32_t ray, light;
    std::size_t place;  // among what the light is asked
    glm::dvec3 color;
  };

  std::vector<Waiting> waiting_;
  // of each light
  std::vector<std::vector<scene::Query>> queries_;
  std::vector<boost::container::vector<bool>> unseen_;
};

/// Those of a stage: a point light stands at the end of a segment, a directional one is seen along the whole ray.
struct Shadows {
  explicit Shadows(const scene::Stage& stage)
      : points(stage.lights.size()), directions(stage.directional_lights.size()) {}

  /// Adds the light that is seen to the colours of the rays.
  void add_light(const engine::Engine& engine, std::span<Brought> sums) {
    points.add_seen(sums, [&](auto queries, auto unseen) { engine.occluded_segments(queries, unseen); });
    directions.add_seen(sums, [&](auto queries, auto unseen) {
      met.resize(queries.size());
      engine.first_elements(queries, met);
      // occluded.def.1: something is met, be there a nearest point of it or not.
      for (std::size_t i = 0; i < met.size(); ++i) unseen[i] = met[i].resultado != model::Resultado::miss;
    });
  }

  AskedLights points, directions;
  std::vector<trace::FirstElement> met{};
};

}  // namespace durero::render
