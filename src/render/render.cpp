#include "durero/render/render.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <mutex>
#include <stdexcept>

#include "durero/render/camera.hpp"

namespace durero::render {
namespace {

using model::Tipo;

/// Half the gradient of potencia at w: with q = w − centro and s = q·d, of |q|² − (2 − d·d)s² and, for a cone, of
/// −(proporcion·(altura − s))² too.
glm::dvec3 gradient(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& w) {
  if (element.tipo == Tipo::soy_esfera) return w - scene.shapes<scene::Sphere>()[element.index].centro;
  if (element.tipo == Tipo::soy_cilindro) {
    const scene::Cylinder& c = scene.shapes<scene::Cylinder>()[element.index];
    const glm::dvec3 q = w - c.centro;
    return q - c.vector * ((2 - glm::dot(c.vector, c.vector)) * glm::dot(q, c.vector));
  }
  const scene::Cone& c = scene.shapes<scene::Cone>()[element.index];
  const glm::dvec3 q = w - c.centro;
  const double s = glm::dot(q, c.vector);
  const double slope = c.proporcion * c.proporcion * (c.altura - s);
  return q + c.vector * (slope - (2 - glm::dot(c.vector, c.vector)) * s);
}

/// The element whose look a point has: the first by name.
scene::ElementRef front(const scene::Scene& scene, const scene::ElementSet& elements) {
  return *std::min_element(elements.begin(), elements.end(),
                           [&](auto a, auto b) { return scene.name(a) < scene.name(b); });
}

glm::dvec3 own_color(const scene::Scene& scene, scene::ElementRef element) {
  const auto material = scene.material(element);
  return material ? scene.stage().materials[*material].color : default_color;
}

/// Lambert's law for one light: max(0, L·N), or 0 where something stands between.
double lambert(const Tracer& tracer, const scene::Hit& hit, const glm::dvec3& n, const glm::dvec3& light) {
  const glm::dvec3 to_light = light - hit.punto;
  const double distance = glm::length(to_light);
  const double intensity = glm::dot(to_light, n) / distance;
  if (!(intensity > 0)) return 0;  // behind the surface, or a light in the very point
  const model::Rayo shadow{model::Punto(hit.punto), model::Vector(to_light)};
  return tracer.occluded_segment(shadow, hit.elementos) ? 0 : intensity;
}

/// color of a ray whose first hit is known.
glm::dvec3 color_of(const scene::Scene& scene, const Tracer& tracer, const model::Rayo& ray, const scene::Hit& hit) {
  if (hit.resultado != model::Resultado::hit) return scene.stage().background.value_or(default_background);
  const scene::ElementRef element = front(scene, hit.elementos);
  glm::dvec3 n = normal(scene, element, hit.punto);
  if (glm::dot(n, ray.v().xyz()) > 0) n = -n;  // the side that the ray sees: cylinders and cones are open
  glm::dvec3 light_sum(0);
  for (const scene::Light& light : scene.stage().lights)
    light_sum += light.color * lambert(tracer, hit, n, light.position);
  return own_color(scene, element) * light_sum;
}

/// The first hits of a row of pixels, on the calling thread.
std::vector<scene::Hit> hits_of_row(const Tracer& tracer, const PrimaryRays& rays, std::uint32_t y,
                                    std::uint32_t width) {
  std::vector<scene::Query> row;
  row.reserve(width);
  for (std::uint32_t x = 0; x < width; ++x) {
    const scene::Query pixel{rays.ray(x, y)};
    row.push_back(pixel);
  }
  if (tracer.first_hits) return tracer.first_hits(row, 1);
  std::vector<scene::Hit> hits;
  hits.reserve(width);
  for (const scene::Query& pixel : row) hits.push_back(tracer.first_hit(pixel.rayo, {}));
  return hits;
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

glm::dvec3 normal(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point) {
  const glm::dvec3 g = gradient(scene, element, point);
  const double length = glm::length(g);
  if (length > 0) return g / length;
  return element.tipo == Tipo::soy_cono ? scene.shapes<scene::Cone>()[element.index].vector : glm::dvec3(0, 0, 0);
}

glm::dvec3 color(const scene::Scene& scene, const Tracer& tracer, const model::Rayo& ray) {
  return color_of(scene, tracer, ray, tracer.first_hit(ray, {}));
}

Image render(const scene::Scene& scene, const Tracer& tracer, const Progress& progress) {
  if (!scene.stage().camera) throw std::domain_error("the scene has no camera; expected one");
  const scene::Resolution size = scene.stage().resolution.value_or(default_resolution);
  const PrimaryRays rays(*scene.stage().camera, size);
  Image image(size);
  Counter counter(progress, size.height);
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, size.height), [&](const auto& rows) {
    for (std::uint32_t y = rows.begin(); y != rows.end(); ++y) {
      const std::vector<scene::Hit> hits = hits_of_row(tracer, rays, y, size.width);
      for (std::uint32_t x = 0; x < size.width; ++x) image.set(x, y, color_of(scene, tracer, rays.ray(x, y), hits[x]));
      counter.row_done();
    }
  });
  return image;
}

}  // namespace durero::render
