#include "durero/render/camera.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <stdexcept>

namespace durero::render {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::domain_error(what);
}

glm::dvec3 unit(const glm::dvec3& v, const char* otherwise) {
  const double length = glm::length(v);
  require(length > 0 && std::isfinite(length), otherwise);
  return v / length;
}

}  // namespace

PrimaryRays::PrimaryRays(const scene::Camera& camera, scene::Resolution resolution) : eye_(camera.eye) {
  require(resolution.width > 0 && resolution.height > 0, "the resolution is empty; expected at least 1 × 1");
  require(camera.fov_y > 0 && camera.fov_y < 180, "fov_y is out of range; expected 0 < fov_y < 180");
  const glm::dvec3 forward = unit(camera.look_at - camera.eye, "eye and look_at coincide; expected two points");
  const glm::dvec3 right =
      unit(glm::cross(forward, camera.up), "up is parallel to the view; expected another direction");
  const glm::dvec3 up = glm::cross(right, forward);
  const double width = resolution.width, height = resolution.height;
  const double pixel = 2 * std::tan(glm::radians(camera.fov_y) / 2) / height;  // side of a pixel on the window
  step_x_ = right * pixel;
  step_y_ = up * -pixel;
  upper_left_ = forward - step_x_ * ((width - 1) / 2) - step_y_ * ((height - 1) / 2);
}

model::Rayo PrimaryRays::ray(std::uint32_t x, std::uint32_t y) const {
  return {model::Punto(eye_), model::Vector(upper_left_ + step_x_ * double(x) + step_y_ * double(y))};
}

}  // namespace durero::render
