#include "durero/render/bundle/cones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "cone_cover.hpp"
#include "durero/render/light/directions.hpp"
#include "render/light/encounter.hpp"
#include "render/light/followed.hpp"
#include "render/light/local_model.hpp"
#include "render/sample/by_rows.hpp"
#include "render/sample/points.hpp"
#include "render/sample/view.hpp"

namespace durero::render {
namespace {

/// The widest cone of a dull mirror.
constexpr double widest = 1.4;

void require_drawn(const scene::Stage& stage) {
  for (const scene::Material& m : stage.materials) {
    if (m.k_t > 0)
      throw std::domain_error(fmt::format("material {} lets light through; expected k_t 0 with cones", m.name));
    if (m.bump) throw std::domain_error(fmt::format("material {} has a relief; expected none with cones", m.name));
  }
  for (const scene::Light& light : stage.lights)
    if (!light.extent.is_point() && light.extent.shape != scene::LightShape::sphere)
      throw std::domain_error("a light has another shape than a point or a sphere; expected these with cones");
  if (stage.camera && (stage.camera->aperture > 0 || stage.camera->shutter > 0))
    throw std::domain_error("the camera has a lens or a shutter; expected a pinhole with cones");
}

std::vector<ConeTarget> targets_of(const scene::Scene& scene) {
  std::vector<ConeTarget> targets;
  scene.for_each([&]<class Shape>(scene::ElementRef e, const Shape& shape) {
    if constexpr (std::is_constructible_v<ConeTarget, scene::ElementRef, const Shape&>)
      targets.emplace_back(e, shape);
    else
      throw std::domain_error(fmt::format("element {} is no sphere, plane or triangle; expected these alone with cones",
                                          scene.name(e).name()));
  });
  return targets;
}

/// A cone on its way.
struct ConePath {
  RayCone cone;
  scene::Query axis;  ///< the ray in the middle, and the elements that the cone starts on
  glm::dvec3 weight{1};
  std::uint32_t depth = 1;
  double way = 0;
};

class ConeTracer {
 public:
  ConeTracer(const scene::Scene& scene, const engine::Engine& engine, std::uint32_t max_depth)
      : scene_(scene), engine_(engine), context_(scene, engine, {max_depth}, nullptr), targets_(targets_of(scene)) {
    require_drawn(scene.stage());
  }

  /// The colour that a cone brings.
  glm::dvec3 brought(const ConePath& path) const {
    glm::dvec3 sum(0);
    ElementLooks looks(context_);
    follow(path, looks, sum);
    return sum;
  }

 private:
  void follow(const ConePath& path, ElementLooks& looks, glm::dvec3& sum) const {
    if (path.depth > context_.limits.max_depth) return;
    if (path.cone.half == 0) {
      const scene::Hit hit = engine::first_hit(engine_, path.axis);
      if (hit.resultado == model::Resultado::hit)
        meet(path, path.axis, hit, 1, looks, sum);
      else
        sum += path.weight * from_nowhere(scene_.stage(), path.axis.rayo.v().xyz());
      return;
    }
    for (const ConePart& part : parts_of(path.cone, targets_, path.axis.en)) {
      const glm::dvec3 d = path.cone.direction(part.at);
      if (!part.target || !std::isfinite(part.t)) {
        sum += path.weight * part.share * from_nowhere(scene_.stage(), d);
        continue;
      }
      const scene::Query query{{path.axis.rayo.p(), model::Vector(d)}, path.axis.en};
      meet(path, query, {model::Resultado::hit, part.t, path.cone.apex + part.t * d, {part.target->element()}},
           part.share, looks, sum);
    }
  }

  void meet(const ConePath& path, const scene::Query& query, const scene::Hit& hit, double share, ElementLooks& looks,
            glm::dvec3& sum) const {
    const Encounter at = encounter_of(context_, query, hit, path.way, looks);
    const glm::dvec3 weight = path.weight * share;
    sum += weight * (at.look.emission + at.look.ambient);
    add_lights(at, weight, sum);
    const glm::dvec3 mirror = weight * (at.look.k_ps * at.look.M_PS);
    if (mirror != glm::dvec3(0)) follow(mirrored_path(path.cone, at, mirror, path.depth + 1), looks, sum);
  }

  void add_lights(const Encounter& at, const glm::dvec3& weight, glm::dvec3& sum) const {
    const std::vector<scene::Light>& lights = scene_.stage().lights;
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const scene::Light& light = lights[i];
      const glm::dvec3 to_light = light.position - at.hit.punto;
      if (to_light == glm::dvec3(0)) continue;
      const double length = glm::length(to_light);
      const glm::dvec3 l = to_light / length;
      const glm::dvec3 seen = sent(at, l, glm::dot(to_light, at.facing) / length);
      const glm::dvec3 color = weight * (light.color * context_.cones.share(i, l) * seen);
      if (color == glm::dvec3(0)) continue;
      sum += color * open(at, to_light, light.extent.shape == scene::LightShape::sphere ? light.extent.radius : 0);
    }
    for (const scene::DirectionalLight& light : scene_.stage().directional_lights) {
      const glm::dvec3 l = -unit(light.direction);
      const glm::dvec3 color = weight * (light.color * sent(at, l, glm::dot(l, at.facing)));
      if (color == glm::dvec3(0)) continue;
      const scene::Query query{{model::Punto(at.hit.punto), model::Vector(-light.direction)}, at.hit.elementos};
      if (engine::first_hit(engine_, query).resultado == model::Resultado::miss) sum += color;
    }
  }

  /// The share of the cone from a point to a light of that radius in which no element stands.
  double open(const Encounter& at, const glm::dvec3& to_light, double radius) const {
    const double length = glm::length(to_light);
    if (radius == 0) {
      const scene::Query query{{model::Punto(at.hit.punto), model::Vector(to_light)}, at.hit.elementos};
      return engine::occluded_segment(engine_, query) ? 0 : 1;
    }
    if (length <= radius) return 1;
    double share = 0;
    const RayCone cone(at.hit.punto, to_light / length, std::asin(radius / length));
    for (const ConePart& part : parts_of(cone, targets_, at.hit.elementos, length))
      if (!part.target) share += part.share;
    return share;
  }

  /// The cone that a mirror sends on. It comes from the mirror image of the apex where the mirror is flat and bright; a
  /// curved or dull mirror makes it wider, from an apex that is nearer.
  ConePath mirrored_path(const RayCone& came, const Encounter& at, const glm::dvec3& weight,
                         std::uint32_t depth) const {
    const glm::dvec3 r = mirrored_way(at);
    const double radius = glm::distance(came.apex, at.hit.punto) * came.tangent;  // of the cone, here
    const double lobe = std::isinf(at.look.gloss) ? 0 : half_angle(2 * std::numbers::pi / (at.look.gloss + 1));
    const double half = std::min(widest, came.half + 2 * radius * bending(at.element) + lobe);
    const double back = half > 0 ? radius / std::tan(half) : 0;
    ConePath path{RayCone(at.hit.punto - back * unit(r), unit(r), half),
                  {{model::Punto(at.hit.punto), model::Vector(r)}, at.hit.elementos},
                  weight,
                  depth,
                  at.way};
    path.cone.start = back;
    return path;
  }

  /// One over the radius of an element; 0 of a flat one.
  double bending(scene::ElementRef element) const {
    return scene_.visit(element, [](const auto& shape) {
      if constexpr (
          requires { shape.radio; } && !requires { shape.vector; })
        return 1 / shape.radio;
      else
        return 0.0;
    });
  }

  const scene::Scene& scene_;
  const engine::Engine& engine_;
  TracingContext context_;
  std::vector<ConeTarget> targets_;
};

}  // namespace

bool cones_are_rays(const scene::Stage& stage, double spread) {
  return spread == 0 &&
         std::ranges::all_of(stage.lights, [](const scene::Light& light) { return light.extent.is_point(); }) &&
         std::ranges::all_of(stage.materials, [](const scene::Material& m) { return std::isinf(m.gloss); });
}

Picture by_cones(const scene::Scene& scene, const engine::Engine& engine, const Progress& progress,
                 const RenderSettings& frame, double spread) {
  const View view(scene, engine, frame);
  const ConeTracer tracer(scene, engine, view.limits.max_depth);
  const scene::Resolution size = view.crop.size;
  const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(frame.samples.most)));
  const double part = spread * glm::length(view.rays.step_x()) / side;  // of the window, at the distance 1
  Picture picture(size);
  by_rows(size.height, progress, [&](std::uint32_t y) {
    for (std::uint32_t x = 0; x < size.width; ++x) {
      glm::dvec3 sum(0);
      for (std::uint32_t i = 0; i < frame.samples.most; ++i) {
        const glm::dvec2 at = glm::dvec2(view.crop.x + x, view.crop.y + y) + in_grid(side, i);
        const model::Rayo ray = view.rays.ray_at(at.x, at.y);
        // A square of the window is seen from the distance |v|, under an angle whose cosine is 1/|v|.
        const double half = half_angle(part * part / std::pow(glm::length(ray.v().xyz()), 3));
        sum += tracer.brought({RayCone(ray.p().xyz(), unit(ray.v().xyz()), half), {ray}});
      }
      picture.rgb[std::size_t(y) * size.width + x] = sum / double(frame.samples.most);
    }
  });
  return picture;
}

}  // namespace durero::render
