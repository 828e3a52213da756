#include "durero/render/light/planar_mirror.hpp"

#include <glm/geometric.hpp>
#include <limits>

#include "durero/render/light/directions.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {
namespace {

scene::Camera behind(const scene::Camera& camera, const glm::dvec3& point, const glm::dvec3& normal) {
  const auto image = [&](const glm::dvec3& p) { return point + mirrored(p - point, normal); };
  return {.eye = image(camera.eye),
          .look_at = image(camera.look_at),
          .up = mirrored(camera.up, normal),
          .fov_y = camera.fov_y,
          .mirrored = !camera.mirrored};
}

}  // namespace

SecondCamera::SecondCamera(const scene::Camera& camera, scene::Resolution resolution, const glm::dvec3& point,
                           const glm::dvec3& normal)
    : camera_(behind(camera, point, normal)), rays_(camera_, resolution), point_(point), normal_(normal) {}

std::optional<model::Rayo> SecondCamera::ray(std::uint32_t x, std::uint32_t y) const {
  const model::Rayo ray = rays_.ray(x, y);
  const double t = glm::dot(point_ - ray.p().xyz(), normal_) / glm::dot(ray.v().xyz(), normal_);
  if (!(t > 0) || t > std::numeric_limits<double>::max()) return std::nullopt;
  return model::Rayo(model::Punto(ray.p().xyz() + t * ray.v().xyz()), ray.v());
}

}  // namespace durero::render
