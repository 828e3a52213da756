#include "durero/engine/engine.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "buffers.hpp"
#include "durero/accel/bsp.hpp"
#include "durero/accel/bvh.hpp"
#include "durero/accel/classification.hpp"
#include "durero/accel/grid.hpp"
#include "durero/accel/item_buffer.hpp"
#include "durero/accel/linear.hpp"
#include "durero/accel/octree.hpp"
#include "durero/accel/volumes.hpp"
#include "durero/accel/wide/wide_bvh.hpp"
#include "durero/oracle/sampled.hpp"
#include "durero/surface/exact.hpp"
#include "durero/surface/normal.hpp"
#include "durero/trace/analytic.hpp"
#include "fast.hpp"
#include "one_by_one.hpp"
#include "rescaled.hpp"
#include "sphere_traced.hpp"
#include "structured.hpp"
#include "unit.hpp"

namespace durero::engine {
namespace {

using scene::Query;
using scene::Scene;

/// The oracle of samples as an engine. It ignores origins, because a sample stands for all points within its covering
/// radius, and cannot tell a ray's start on an element from a nearby hit of that element.
class Sampled final : public Engine {
 public:
  explicit Sampled(const Scene& scene) : oracle_(scene) {}

  void first_hits(std::span<const Query> queries, std::span<scene::Hit> hits) const override {
    oracle_.first_hits(queries, hits);
  }
  void occluded_segments(std::span<const Query> queries, std::span<bool> occluded) const override {
    const std::vector<scene::Hit> hits = engine::first_hits(*this, queries);
    std::ranges::transform(hits, occluded.begin(),
                           [](const scene::Hit& hit) { return hit.resultado == model::Resultado::hit && hit.t < 1; });
  }

 private:
  oracle::sampled::Oracle oracle_;
};

std::unique_ptr<const Engine> sampled(const Scene& scene) { return std::make_unique<const Sampled>(scene); }

std::unique_ptr<const Engine> exact(const Scene& scene) {
  return one_by_one(
      [&scene](const Query& query) { return surface::exact::first_hit(scene, query.rayo, query.en); },
      [&scene](const Query& query) { return surface::exact::occluded_segment(scene, query.rayo, query.en); });
}

class Analytic final : public Engine {
 public:
  explicit Analytic(const Scene& scene) : tables_(scene) {}

  void first_hits(std::span<const Query> queries, std::span<scene::Hit> hits) const override {
    trace::first_hits(tables_, queries, hits);
  }
  void occluded_segments(std::span<const Query> queries, std::span<bool> occluded) const override {
    trace::occluded_segments(tables_, queries, occluded);
  }
  std::optional<std::vector<surface::exact::ElementPoint>> points_between(
      const scene::Scene&, const scene::Query& query, surface::exact::RayStretch stretch,
      const surface::exact::Passes& passes) const override {
    return trace::points_between_among(tables_, query, stretch, passes);
  }

 private:
  trace::Tables tables_;
};

std::unique_ptr<const Engine> analytic(const Scene& scene) { return std::make_unique<const Analytic>(scene); }

/// `fast` for a scene. A scene whose lengths lie outside the range of the bounds is answered in a unit of length in
/// which they lie inside.
std::unique_ptr<const Engine> fast(const Scene& scene) {
  if (const auto unit = unit_of(scene)) return std::make_unique<const Rescaled<Fast>>(scene, *unit);
  return std::make_unique<const Fast>(scene);
}

/// Measures `fast` in the unit of length that it answers in, without the rays that are not exact there.
Figures measured_fast(const Scene& scene, std::span<const Query> queries) {
  const auto unit = unit_of(scene);
  if (!unit) return measured<accel::WideBvh>(scene, queries);
  std::vector<Query> in_that_unit;
  for (const Query& query : queries)
    if (const auto ray = in_unit(query.rayo, *unit)) in_that_unit.push_back({ray->rayo, query.en});
  return measured<accel::WideBvh>(in_unit(scene, *unit), in_that_unit);
}

constexpr std::array rows = {
    EngineRow{"sampled", "points on the surfaces: coarse, and independent of every formula", false, false, sampled},
    EngineRow{"exact", "exact arithmetic throughout: slow, and what all others are held against", true, true, exact},
    EngineRow{"analytic", "closed forms in binary64, certified, exact where they cannot tell", true, true, analytic,
              "A §1.2", measured<accel::LinearList>},
    EngineRow{
        "sdf",
        "sphere tracing by distances, until one is below a millionth of the scene: takes what it passes closely for "
        "met, and gives a ray up after 1000 steps",
        false, true, sphere_traced},
    EngineRow{
        "volumes",
        "each element in the bounding volume of the kind that costs least: slower than analytic, which scans eight at "
        "once",
        true, true, structured<accel::Volumes>, "A §1.2", measured<accel::Volumes>},
    EngineRow{"bvh-glassner", "a hierarchy of boxes, searched as the text has it: to be read", true, true,
              structured<accel::BvhGlassner>, "A §1.3.1", measured<accel::BvhGlassner>},
    EngineRow{"bvh", "a hierarchy of boxes by surface area, the nearest first", true, true, structured<accel::Bvh>,
              "A §1.3", measured<accel::Bvh>, structured<accel::Bvh, scene::Groups>,
              measured<accel::Bvh, scene::Groups>},
    EngineRow{"octree", "cubes that are divided in eight where elements are, walked from sibling to sibling", true,
              true, structured<accel::Octree>, "A §1.4.2", measured<accel::Octree>},
    EngineRow{"octree-by-location", "the same, each cube found from the root by a point of the ray in it", true, true,
              structured<accel::OctreeByLocation>, "A §1.4.2", measured<accel::OctreeByLocation>},
    EngineRow{"bsp", "cells halved by planes where these cost least, walked by Jansen's recursion", true, true,
              structured<accel::Bsp>, "A §1.4.2", measured<accel::Bsp>},
    EngineRow{"bsp-median", "the same, with as many elements on either side of a plane", true, true,
              structured<accel::BspMedian>, "A §1.4.2", measured<accel::BspMedian>},
    EngineRow{"grid", "equal cubes, of which a ray visits those that it crosses (SEADS, 3DDDA)", true, true,
              structured<accel::Grid>, "A §1.4.3", measured<accel::Grid>},
    EngineRow{"item-buffer", "what each pixel of the camera sees, for primary rays; other rays as bvh", true, true,
              structured<accel::ItemBuffer>, "A §1.5", measured_item_buffer},
    EngineRow{"light-buffer", "lists about each light, for shadow rays; other rays as analytic", true, true,
              light_buffer, "A §1.6.1", measured_light_buffer},
    EngineRow{
        "classification",
        "lists of what the rays of a box and a direction may meet, made when asked for: slower than analytic where "
        "rays have "
        "little in common",
        true, true, structured<accel::Classification>, "A §1.6", measured<accel::Classification>},
    EngineRow{"fast", "analytic over a wide tree of boxes, many rays together", true, true, fast, "A §1.3",
              measured_fast},
};

}  // namespace

std::span<const EngineRow> engines() { return rows; }

const EngineRow* find(std::string_view name) {
  const auto found = std::ranges::find(rows, name, &EngineRow::name);
  return found == rows.end() ? nullptr : std::to_address(found);
}

/// Takes the elements from whole hits, some queries at a time.
void Engine::first_elements(std::span<const Query> queries, std::span<trace::FirstElement> elements) const {
  constexpr std::size_t at_a_time = 1 << 16;
  std::vector<scene::Hit> hits(std::min(queries.size(), at_a_time));
  for (std::size_t begin = 0; begin < queries.size(); begin += at_a_time) {
    const auto some = queries.subspan(begin, std::min(at_a_time, queries.size() - begin));
    first_hits(some, std::span(hits).first(some.size()));
    for (std::size_t i = 0; i < some.size(); ++i) elements[begin + i] = trace::first_element(hits[i]);
  }
}

std::optional<std::vector<surface::exact::ElementPoint>> Engine::points_between(
    const Scene& scene, const Query& query, surface::exact::RayStretch stretch,
    const surface::exact::Passes& passes) const {
  return surface::exact::points_between(scene, query.rayo, query.en, stretch, passes);
}

glm::dvec3 Engine::normal(const Scene& scene, scene::ElementRef element, const glm::dvec3& point) const {
  return surface::normal(scene, element, point);
}

std::vector<scene::Hit> first_hits(const Engine& engine, std::span<const Query> queries) {
  std::vector<scene::Hit> hits(queries.size());
  engine.first_hits(queries, hits);
  return hits;
}

scene::Hit first_hit(const Engine& engine, const Query& query) {
  scene::Hit hit;
  engine.first_hits({&query, 1}, {&hit, 1});
  return hit;
}

bool occluded_segment(const Engine& engine, const Query& query) {
  bool occluded = false;
  engine.occluded_segments({&query, 1}, {&occluded, 1});
  return occluded;
}

}  // namespace durero::engine
