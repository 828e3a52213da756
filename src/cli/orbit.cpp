#include "orbit.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "durero/composed/figure.hpp"
#include "durero/scene/shapes.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::cli {
namespace {

constexpr double least_polar = glm::pi<double>() / 180;

bool is_finite(const glm::dvec3& x) { return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z); }

/// The right side of the picture and its upper side, of length 1. For a mirrored camera the right side is the left one.
struct PictureSides {
  glm::dvec3 right, up;
};

PictureSides sides_of(const scene::Camera& camera) {
  const glm::dvec3 ahead = glm::normalize(camera.look_at - camera.eye);
  const glm::dvec3 right = glm::normalize(glm::cross(ahead, camera.up));
  return {camera.mirrored ? -right : right, glm::cross(right, ahead)};
}

}  // namespace

scene::Camera camera_of_whole(const scene::Scene& scene) {
  glm::dvec3 low(INFINITY), high(-INFINITY);
  scene.for_each([&](scene::ElementRef element, const auto& shape) {
    const scene::Body* const body = scene.body(element);
    const surface::Box box = body != nullptr ? composed::figure(*body)->box() : surface::box(shape);
    if (!is_finite(box.low) || !is_finite(box.high)) return;
    low = glm::min(low, box.low);
    high = glm::max(high, box.high);
  });
  const bool is_empty = !is_finite(low);
  const glm::dvec3 middle = is_empty ? glm::dvec3(0) : low / 2.0 + high / 2.0;
  const double radius = is_empty ? 1 : std::max(glm::length(high / 2.0 - low / 2.0), 0x1p-40);
  return {.eye = middle + 3 * radius * glm::normalize(glm::dvec3(1, 1, -2)),
          .look_at = middle,
          .up = {0, 1, 0},
          .fov_y = 40};
}

scene::Camera turned(scene::Camera camera, double to_the_right, double upwards) {
  const glm::dvec3 way = camera.eye - camera.look_at, pole = glm::normalize(camera.up);
  const glm::dvec3 aside = sides_of(camera).right, towards = glm::cross(pole, aside);  // away from the pole's axis
  const double distance = glm::length(way), sign = glm::dot(towards, way) < 0 ? -1 : 1;
  const double polar =
      std::clamp(std::acos(std::clamp(glm::dot(way, pole) / distance, -1.0, 1.0)) - glm::radians(upwards), least_polar,
                 glm::pi<double>() - least_polar);
  const double turn = glm::radians(to_the_right);
  const glm::dvec3 level = std::cos(turn) * sign * towards + std::sin(turn) * aside;
  camera.eye = camera.look_at + distance * (std::cos(polar) * pole + std::sin(polar) * level);
  return camera;
}

scene::Camera at_times_the_distance(scene::Camera camera, double times) {
  const glm::dvec3 eye = camera.look_at + times * (camera.eye - camera.look_at);
  if (is_finite(eye) && eye != camera.look_at) camera.eye = eye;
  return camera;
}

scene::Camera moved(scene::Camera camera, double to_the_right, double upwards) {
  const PictureSides sides = sides_of(camera);
  const glm::dvec3 by = glm::length(camera.eye - camera.look_at) * (to_the_right * sides.right + upwards * sides.up);
  camera.eye += by;
  camera.look_at += by;
  return camera;
}

scene::Camera looking_at(scene::Camera camera, const glm::dvec3& point) {
  const glm::dvec3 way = camera.eye - camera.look_at;
  camera.look_at = point;
  camera.eye = point + way;
  return camera;
}

}  // namespace durero::cli
