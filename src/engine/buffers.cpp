#include "buffers.hpp"

#include <algorithm>
#include <vector>

#include "durero/accel/item_buffer.hpp"
#include "durero/accel/light_buffer.hpp"
#include "durero/accel/linear.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/stage.hpp"
#include "durero/trace/analytic.hpp"
#include "structured.hpp"

namespace durero::engine {
namespace {

using scene::Query;
using scene::Scene;

class LightBuffered final : public Engine {
 public:
  explicit LightBuffered(const Scene& scene) : buffer_(scene) {}

  void first_hits(std::span<const Query> queries, std::span<scene::Hit> hits) const override {
    trace::first_hits(buffer_.tables(), queries, hits);
  }
  void occluded_segments(std::span<const Query> queries, std::span<bool> occluded) const override {
    trace::for_each_block(queries.size(), [&](std::size_t begin, std::size_t count) {
      trace::Counts unseen;
      for (std::size_t i = begin; i < begin + count; ++i) {
        const auto& [rayo, en] = queries[i];
        occluded[i] = buffer_.is_certainly_occluded(trace::Ray(rayo), en) ||
                      trace::occluded_segment_among(accel::CandidateSource(buffer_), rayo, en, unseen);
      }
    });
  }
  std::optional<std::vector<surface::exact::ElementPoint>> points_between(
      const scene::Scene&, const scene::Query& query, surface::exact::RayStretch stretch,
      const surface::exact::Passes& passes) const override {
    return trace::points_between_among(buffer_.tables(), query, stretch, passes);
  }

 private:
  accel::LightBuffer buffer_;
};

/// The shadow rays of some rays: segments from their first hits to each light.
std::vector<Query> shadow_rays(const Scene& scene, const trace::Tables& tables, std::span<const Query> queries) {
  std::vector<Query> shadows;
  for (const Query& query : queries) {
    const scene::Hit hit = trace::first_hit(tables, query.rayo, query.en);
    if (hit.resultado != model::Resultado::hit) continue;
    for (const scene::Light& light : scene.stage().lights) {
      const glm::dvec3 to_light = light.position - hit.punto;
      if (to_light == glm::dvec3(0)) continue;
      const Query shadow{{model::Punto(hit.punto), model::Vector(to_light)}, hit.elementos};
      shadows.push_back(shadow);
    }
  }
  return shadows;
}

}  // namespace

std::unique_ptr<const Engine> light_buffer(const Scene& scene) { return std::make_unique<const LightBuffered>(scene); }

Figures measured_light_buffer(const Scene& scene, std::span<const Query> queries) {
  trace::Counts unseen;
  Figures figures{};
  figures.asked = "shadows";
  std::optional<accel::LightBuffer> made;
  figures.building_seconds = seconds_of([&] { made.emplace(scene); });
  const accel::LightBuffer& buffer = *made;
  figures.size = buffer.size();
  const std::vector<Query> shadows = shadow_rays(scene, buffer.tables(), queries);
  const auto for_each_shadow = [&](const auto& answer) {
    return seconds_of([&] {
      for (const auto& [rayo, en] : shadows) answer(rayo, scene::Origin(en));
    });
  };
  figures.answering_seconds = for_each_shadow([&](const model::Rayo& rayo, scene::Origin en) {
    if (!buffer.is_certainly_occluded(trace::Ray(rayo), en))
      trace::occluded_segment_among(accel::CandidateSource(buffer), rayo, en, unseen);
  });
  figures.without_seconds = for_each_shadow([&](const model::Rayo& rayo, scene::Origin en) {
    trace::occluded_segment_among(buffer.tables(), rayo, en, unseen);
  });
  const accel::Counted counted(buffer, figures.work);
  for_each_shadow([&](const model::Rayo& rayo, scene::Origin en) {
    if (buffer.is_certainly_occluded(trace::Ray(rayo), en)) {
      figures.work += {.rays = 1, .untested = 1};
    } else {
      trace::occluded_segment_among(counted, rayo, en, unseen);
    }
  });
  return figures;
}

Figures measured_item_buffer(const Scene& scene, std::span<const Query> queries) {
  std::vector<Query> primary;
  if (const auto rays = accel::primary_rays(scene.stage())) {
    const auto [width, height] = rays->resolution();
    const std::uint64_t pixels = std::uint64_t{width} * height, count = std::min<std::uint64_t>(pixels, queries.size());
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint64_t pixel = i * pixels / count;
      const Query query{
          rays->ray(static_cast<std::uint32_t>(pixel % width), static_cast<std::uint32_t>(pixel / width))};
      primary.push_back(query);
    }
  }
  Figures figures = measured<accel::ItemBuffer>(scene, primary);
  figures.asked = "primary hits";
  figures.without_seconds = measured<accel::LinearList>(scene, primary).answering_seconds;
  return figures;
}

}  // namespace durero::engine
