#pragma once
/// A shadow query asks whether a point sees a light; a colour waits for the answer.

#include <boost/container/vector.hpp>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "clear_elements.hpp"
#include "durero/engine/engine.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/stage.hpp"
#include "followed.hpp"
#include "query_pool.hpp"

namespace durero::render {

/// The start of a shadow query.
struct ShadowStart {
  std::uint32_t ray;      ///< the ray whose colour waits for the answer
  const scene::Hit& hit;  ///< the point that sees a light or not
  double way;             ///< the length from the eye to the point
};

/// The colours that wait for lights of one kind. An engine is asked light by light, since neighbouring points have
/// similar ways to one light; colours are added in the order in which they came.
class AskedLights {
 public:
  explicit AskedLights(std::size_t lights) : queries_(lights), unseen_(lights) {}

  /// Adds a query: whether the light of this number is seen from the start. The colour of the ray waits for the answer.
  void add(std::size_t light, const ShadowStart& from, const glm::dvec3& color, const glm::dvec3& to_light) {
    if (color == glm::dvec3(0)) return;
    QueryPool& queries = queries_[light];
    waiting_.push_back({from.ray, static_cast<std::uint32_t>(light), queries.size(), from.way, color});
    queries.push({model::Punto(from.hit.punto), model::Vector(to_light)}, from.hit.elementos);
  }

  /// Adds each colour to that of its ray where its light is seen, or what is left of it; no query waits after that.
  /// unseen(queries, answers) tells for which queries the light is not seen, and left(query, way) which share of such a
  /// light is left.
  template <class Unseen, class Left>
  void add_seen(std::span<PathRadiance> sums, Unseen&& unseen, Left&& left) {
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      unseen_[i].resize(queries_[i].size());
      unseen(queries_[i].all(), std::span<bool>(unseen_[i].data(), unseen_[i].size()));
    }
    for (const Waiting& one : waiting_) {
      if (!unseen_[one.light][one.place]) {
        sums[one.ray].color += one.color;
      } else if (const glm::dvec3 share = left(queries_[one.light][one.place], one.way); share != glm::dvec3(0)) {
        sums[one.ray].color += share * one.color;
      }
    }
    for (QueryPool& of_light : queries_) of_light.clear();
    waiting_.clear();
  }

 private:
  struct Waiting {
    std::uint32_t ray, light;
    std::size_t place;  // of the query among those of its light
    double way;
    glm::dvec3 color;
  };

  std::vector<Waiting> waiting_;
  // of each light
  std::vector<QueryPool> queries_;
  std::vector<boost::container::vector<bool>> unseen_;
};

/// The shadow queries of a stage: a point light stands at the end of a segment, a directional one is seen along the
/// whole ray.
struct Shadows {
  explicit Shadows(const TracingContext& context)
      : points(context.scene.stage().lights.size()),
        directions(context.scene.stage().directional_lights.size()),
        clear(context),
        coloured(clear.count()) {}

  /// The share that is left of a light that something stands before.
  auto left(surface::exact::RayStretch stretch) const {
    return [this, stretch](const scene::Query& query, double way) {
      return coloured ? clear.share_through(query, stretch, way) : glm::dvec3(0);
    };
  }

  /// Adds the colours of the seen lights to the sums of the rays.
  void add_light(const engine::Engine& engine, std::span<PathRadiance> sums) {
    using surface::exact::RayStretch;
    points.add_seen(
        sums, [&](auto queries, auto unseen) { engine.occluded_segments(queries, unseen); }, left(RayStretch::segment));
    directions.add_seen(
        sums,
        [&](auto queries, auto unseen) {
          met.resize(queries.size());
          engine.first_elements(queries, met);
          // occluded.def.1: the way meets an element, with or without a nearest point.
          for (std::size_t i = 0; i < met.size(); ++i) unseen[i] = met[i].resultado != model::Resultado::miss;
        },
        left(RayStretch::whole));
  }

  AskedLights points, directions;
  ClearElements clear;
  bool coloured;
  std::vector<trace::FirstElement> met{};
};

}  // namespace durero::render
