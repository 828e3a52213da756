#pragma once
/// Rays that are followed one at a time, on surfaces that a test can tell the colours of.

#include <algorithm>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>

#include "durero/engine/engine.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/stage.hpp"
#include "render/lit_ball.hpp"
#include "support/catch.hpp"

namespace durero::test {

inline const scene::ElementRef ball{model::Tipo::soy_esfera, 0}, blocker{model::Tipo::soy_esfera, 1};

/// Answers every ray with one hit, and every shadow ray with one word; remembers what the shadow rays started on.
struct Fake : engine::Engine {
  scene::Hit hit;
  bool shadow;
  mutable scene::ElementSet origin{};

  explicit Fake(const scene::Hit& every = {}, bool in_shadow = false) : hit(every), shadow(in_shadow) {}

  void first_hits(std::span<const scene::Query>, std::span<scene::Hit> hits) const override {
    std::fill(hits.begin(), hits.end(), hit);
  }
  void occluded_segments(std::span<const scene::Query> queries, std::span<bool> occluded) const override {
    for (const scene::Query& query : queries) {
      origin = query.en;
      CHECK(query.rayo.p().xyz() == hit.punto);
    }
    std::fill(occluded.begin(), occluded.end(), shadow);
  }
};

inline glm::dvec3 color(const scene::Scene& scene, const engine::Engine& engine, const model::Rayo& ray,
                        std::uint32_t max_depth = 1) {
  const scene::Query query{ray};
  return render::brought(scene, engine, {&query, 1}, {max_depth}).at(0).color;
}

/// The colour by the exact engine, and how many rays it was asked, and how many of them to point lights.
struct Traced {
  glm::dvec3 color;
  std::size_t rays, shadow_rays;
};

inline Traced traced(const scene::Scene& scene, const model::Rayo& ray, std::uint32_t max_depth) {
  struct Counting : engine::Engine {
    const engine::Engine& of;
    mutable std::size_t asked = 0, asked_to_lights = 0;
    explicit Counting(const engine::Engine& engine) : of(engine) {}
    void first_hits(std::span<const scene::Query> queries, std::span<scene::Hit> hits) const override {
      asked += queries.size();
      of.first_hits(queries, hits);
    }
    void occluded_segments(std::span<const scene::Query> queries, std::span<bool> occluded) const override {
      asked_to_lights += queries.size();
      of.occluded_segments(queries, occluded);
    }
  };
  const auto exact = engine::find("exact")->prepare(scene);
  const Counting counting(*exact);
  const glm::dvec3 seen = color(scene, counting, ray, max_depth);
  return {seen, counting.asked, counting.asked_to_lights};
}

/// A plane through a point of the x axis, across it, with that material.
inline void add_wall(scene::Scene& scene, const char* name, double x, double facing, const scene::Material& look) {
  const auto index = static_cast<std::uint32_t>(scene.stage().materials.size());
  scene.stage().materials.push_back(look);
  scene.apply(model::Agregar_Plano{model::Elemento(name), {x, 0, 0}, {facing, 0, 0}});
  scene.set_material(*scene.find(name), index);
}

inline const model::Rayo down{{0, 5, 0}, {0, -1, 0}}, along{{0.5, 0, 0}, {1, 0, 0}};
inline const scene::Hit above{model::Resultado::hit, 4, {0, 1, 0}, {ball}};
inline const glm::dvec3 black(0);

}  // namespace durero::test
