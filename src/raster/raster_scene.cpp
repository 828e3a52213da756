#include "durero/raster/raster_scene.hpp"

#include <memory>
#include <stdexcept>

#include "durero/model/tipos.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/render/still_scene.hpp"
#include "durero/trace/first_element.hpp"

namespace durero::raster {
namespace {

const scene::Camera& camera_of(const scene::Scene& scene) {
  if (scene.stage().environment) throw std::domain_error("an environment surrounds the scene; expected a background");
  return render::still_camera(scene);
}

/// The Z-buffer of the opaque polygons alone: the others are seen, and hide nothing.
ZBuffer drawn_opaque(const std::vector<ScenePolygon>& polygons, const std::vector<polygon::Polygon>& corners,
                     const RasterView& view) {
  std::vector<polygon::Polygon> opaque;
  std::vector<std::uint32_t> places;
  for (std::uint32_t i = 0; i < polygons.size(); ++i) {
    if (polygons[i].material.k_t > 0) continue;
    opaque.push_back(corners[i]);
    places.push_back(i);
  }
  ZBuffer buffer = z_buffer(opaque, view);
  for (std::uint32_t& nearest : buffer.nearest)
    if (nearest != ZBuffer::none) nearest = places[nearest];
  buffer.seen.clear();
  for (const polygon::Polygon& one : corners) buffer.seen.emplace_back(one, view.eye());
  return buffer;
}

}  // namespace

RasterScene::RasterScene(const scene::Scene& scene, scene::Resolution size, Opacity opacity)
    : scene_(&scene),
      polygons_(polygons_of(scene, opacity)),
      corners_(corners_of(polygons_)),
      view_(camera_of(scene), size),
      buffer_(drawn_opaque(polygons_, corners_, view_)) {}

RasterPoint RasterScene::point(std::size_t polygon, std::uint32_t x, std::uint32_t y) const {
  const glm::dvec3 v = view_.direction(x, y);
  return {&polygons_[polygon], view_.eye() + seen(polygon).parameter(v) * v, v};
}

glm::dvec3 RasterScene::background() const { return scene_->stage().background.value_or(render::default_background); }

std::vector<LightColors> lights_by_rays(const scene::Stage& stage, const engine::Engine& engine,
                                        const std::vector<RasterPoint>& points) {
  std::vector<LightColors> lights(points.size(), colors_of(stage));
  const auto ask = [&](std::size_t light, const auto& towards, const auto& unseen) {
    std::vector<scene::Query> queries;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::dvec3 to = towards(points[i].point);
      if (to == glm::dvec3(0)) continue;
      queries.push_back({{model::Punto(points[i].point), model::Vector(to)}, {points[i].polygon->element}});
      places.push_back(i);
    }
    const auto answers = std::make_unique<bool[]>(queries.size());
    unseen(queries, std::span<bool>(answers.get(), queries.size()));
    for (std::size_t i = 0; i < places.size(); ++i)
      if (answers[i]) lights[places[i]][light] = glm::dvec3(0);
  };
  std::size_t next = 0;
  for (const scene::Light& light : stage.lights)
    ask(
        next++, [&](const glm::dvec3& point) { return light.position - point; },
        [&](const auto& queries, std::span<bool> answers) { engine.occluded_segments(queries, answers); });
  for (const scene::DirectionalLight& light : stage.directional_lights)
    ask(
        next++, [&](const glm::dvec3&) { return -light.direction; },
        [&](const auto& queries, std::span<bool> answers) {
          std::vector<trace::FirstElement> met(queries.size());
          engine.first_elements(queries, met);
          for (std::size_t i = 0; i < met.size(); ++i) answers[i] = met[i].resultado != model::Resultado::miss;
        });
  return lights;
}

}  // namespace durero::raster
