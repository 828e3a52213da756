#include "durero/render/render.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <boost/container/vector.hpp>
#include <glm/geometric.hpp>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "durero/scene/camera.hpp"

namespace durero::render {
namespace {

/// The element whose look a point has: the first by name.
scene::ElementRef front(const scene::Scene& scene, const scene::ElementSet& elements) {
  return *std::min_element(elements.begin(), elements.end(),
                           [&](auto a, auto b) { return scene.name(a) < scene.name(b); });
}

glm::dvec3 own_color(const scene::Scene& scene, scene::ElementRef element) {
  const auto material = scene.material(element);
  return material ? scene.stage().materials[*material].color : default_color;
}

/// The light that a point would have by Lambert's law from one light, L·N times its colour, if nothing stands between.
struct Contribution {
  std::size_t ray;
  glm::dvec3 light;
};

/// The points that rays hit, and the questions of what stands between them and the lights.
class Shading {
 public:
  Shading(const scene::Scene& scene, const engine::Engine& engine) : scene_(scene), engine_(engine) {}

  void add(std::size_t ray, const glm::dvec3& v, const scene::Hit& hit, scene::ElementRef element) {
    glm::dvec3 n = engine_.normal(scene_, element, hit.punto);
    if (glm::dot(n, v) > 0) n = -n;  // the side that the ray sees: cylinders and cones are open
    for (const scene::Light& light : scene_.stage().lights) {
      const glm::dvec3 to_light = light.position - hit.punto;
      const double intensity = glm::dot(to_light, n) / glm::length(to_light);
      if (!(intensity > 0)) continue;  // behind the surface, or a light in the very point
      contributions_.push_back({ray, light.color * intensity});
      shadows_.push_back({{model::Punto(hit.punto), model::Vector(to_light)}, hit.elementos});
    }
  }

  /// Adds to each ray's sum what reaches its point.
  void add_light(std::span<glm::dvec3> sums) const {
    boost::container::vector<bool> shadowed(shadows_.size());
    engine_.occluded_segments(shadows_, {shadowed.data(), shadowed.size()});
    for (std::size_t i = 0; i < shadows_.size(); ++i)
      if (!shadowed[i]) sums[contributions_[i].ray] += contributions_[i].light;
  }

 private:
  const scene::Scene& scene_;
  const engine::Engine& engine_;
  std::vector<Contribution> contributions_;
  std::vector<scene::Query> shadows_;
};

/// The rays of row y of a crop.
std::vector<scene::Query> row_of(const scene::PrimaryRays& rays, const Crop& crop, std::uint32_t y) {
  std::vector<scene::Query> row;
  row.reserve(crop.size.width);
  for (std::uint32_t x = 0; x < crop.size.width; ++x) row.push_back({rays.ray(crop.x + x, crop.y + y)});
  return row;
}

/// The crop that is asked for, or the whole picture.
Crop crop_of(const Frame& frame, scene::Resolution size) {
  const Crop crop = frame.crop.value_or(Crop{0, 0, size});
  const auto inside = [](std::uint32_t begin, std::uint32_t length, std::uint32_t whole) {
    return length > 0 && begin < whole && length <= whole - begin;
  };
  if (!inside(crop.x, crop.size.width, size.width) || !inside(crop.y, crop.size.height, size.height))
    throw std::out_of_range("the crop is not inside the picture");
  return crop;
}

/// Counts the rows that are done and tells, without making the threads wait for each other.
class Counter {
 public:
  Counter(const Progress& progress, std::uint32_t rows) : progress_(progress), rows_(rows) {}
  void row_done() {
    if (!progress_) return;
    const std::lock_guard lock(mutex_);
    progress_(double(++done_) / rows_);
  }

 private:
  const Progress& progress_;
  std::mutex mutex_;
  std::uint32_t done_ = 0, rows_;
};

}  // namespace

std::vector<glm::dvec3> colors(const scene::Scene& scene, const engine::Engine& engine,
                               std::span<const scene::Query> rays) {
  const std::vector<scene::Hit> hits = engine::first_hits(engine, rays);
  Shading shading(scene, engine);
  std::vector<std::optional<scene::ElementRef>> fronts(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (hits[i].resultado != model::Resultado::hit) continue;
    fronts[i] = front(scene, hits[i].elementos);
    shading.add(i, rays[i].rayo.v().xyz(), hits[i], *fronts[i]);
  }
  std::vector<glm::dvec3> colors(rays.size(), glm::dvec3(0));
  shading.add_light(colors);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    colors[i] =
        fronts[i] ? own_color(scene, *fronts[i]) * colors[i] : scene.stage().background.value_or(default_background);
  }
  return colors;
}

Image render(const scene::Scene& scene, const engine::Engine& engine, const Progress& progress, const Frame& frame) {
  if (!scene.stage().camera) throw std::domain_error("the scene has no camera; expected one");
  const scene::Resolution size = frame.size.value_or(scene.stage().resolution.value_or(default_resolution));
  const scene::PrimaryRays rays(*scene.stage().camera, size);
  const Crop crop = crop_of(frame, size);
  Image image(crop.size);
  Counter counter(progress, crop.size.height);
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, crop.size.height), [&](const auto& rows) {
    for (std::uint32_t y = rows.begin(); y != rows.end(); ++y) {
      const std::vector<glm::dvec3> row = colors(scene, engine, row_of(rays, crop, y));
      for (std::uint32_t x = 0; x < crop.size.width; ++x) image.set(x, y, row[x]);
      counter.row_done();
    }
  });
  return image;
}

}  // namespace durero::render
