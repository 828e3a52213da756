#include "durero/raster/projector.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

namespace durero::raster {
namespace {

/// The side of a pixel at a distance.
double side_of_pixel(const scene::Camera& camera, std::uint32_t rows, const glm::dvec3& point) {
  return 2 * std::tan(glm::radians(camera.fov_y) / 2) / rows * glm::distance(camera.eye, point);
}

}  // namespace

Projector::Projector(const scene::Camera& camera, scene::TexelImage picture)
    : camera_(camera), picture_(std::move(picture)), view_(camera, {picture_.width, picture_.height}) {}

std::optional<scene::Pixel> Projector::texel_on(const glm::dvec3& point) const {
  const auto place = view_.place(point);
  if (!place) return std::nullopt;
  const glm::dvec2 at = *place + 0.5;
  if (!(at.x >= 0 && at.y >= 0 && at.x < picture_.width && at.y < picture_.height)) return std::nullopt;
  return scene::Pixel{static_cast<std::uint32_t>(at.x), static_cast<std::uint32_t>(at.y)};
}

glm::dvec3 Projector::color_on(const glm::dvec3& point) const {
  const auto texel = texel_on(point);
  return texel ? picture_.at(texel->x, texel->y) : glm::dvec3(0);
}

double Projector::predicted_pixels(const glm::dvec3& point, const scene::Camera& camera,
                                   scene::Resolution resolution) const {
  return side_of_pixel(camera_, picture_.height, point) / side_of_pixel(camera, resolution.height, point);
}

}  // namespace durero::raster
