#include "durero/scene/camera.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <stdexcept>

#include "durero/scene/stage.hpp"

namespace durero::scene {
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

PrimaryRays::PrimaryRays(const Camera& camera, Resolution resolution)
    : resolution_(resolution),
      eye_(camera.eye),
      lens_radius_(camera.aperture / 2),
      focus_(camera.focus > 0 ? camera.focus : glm::length(camera.look_at - camera.eye)) {
  require(resolution.width > 0 && resolution.height > 0, "the resolution is empty; expected at least 1 × 1");
  require(camera.fov_y > 0 && camera.fov_y < 180, "fov_y is out of range; expected 0 < fov_y < 180");
  const glm::dvec3 forward = unit(camera.look_at - camera.eye, "eye and look_at coincide; expected two points");
  const glm::dvec3 across =
      unit(glm::cross(forward, camera.up), "up is parallel to the view; expected another direction");
  const glm::dvec3 up = glm::cross(across, forward), right = camera.mirrored ? -across : across;
  const double width = resolution.width, height = resolution.height;
  const double pixel = 2 * std::tan(glm::radians(camera.fov_y) / 2) / height;  // side of a pixel on the window
  right_ = right;
  up_ = up;
  step_x_ = right * pixel;
  step_y_ = up * -pixel;
  upper_left_ = forward - step_x_ * ((width - 1) / 2) - step_y_ * ((height - 1) / 2);
}

model::Rayo PrimaryRays::ray(std::uint32_t x, std::uint32_t y) const { return ray_at(x, y); }

model::Rayo PrimaryRays::ray_at(double x, double y) const {
  return {model::Punto(eye_), model::Vector(direction(x, y))};
}

// The direction advances by one unit along the view, and so the plane in focus is at t = focus: from elsewhere on the
// lens, the same point is reached there.
model::Rayo PrimaryRays::lens_ray_at(double x, double y, const glm::dvec2& lens) const {
  const glm::dvec3 aside = lens_radius_ * (lens.x * right_ + lens.y * up_);
  return {model::Punto(eye_ + aside), model::Vector(direction(x, y) - aside / focus_)};
}

// Both steps are at right angles to each other and to the view, up to rounding, so that the nearest pixel is the one,
// if any is.
std::optional<Pixel> PrimaryRays::pixel_of(const glm::dvec3& p, const glm::dvec3& v) const {
  if (p != eye_) return std::nullopt;
  const glm::dvec3 within = v - upper_left_;
  const auto nearest = [&](const glm::dvec3& step, std::uint32_t count) -> std::optional<std::uint32_t> {
    const double place = std::floor(glm::dot(within, step) / glm::dot(step, step) + 0.5);
    if (!(place >= 0 && place < count)) return std::nullopt;
    return static_cast<std::uint32_t>(place);
  };
  const auto x = nearest(step_x_, resolution_.width), y = nearest(step_y_, resolution_.height);
  if (!x || !y || direction(*x, *y) != v) return std::nullopt;
  return Pixel{*x, *y};
}

}  // namespace durero::scene
