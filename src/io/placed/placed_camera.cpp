#include "placed_camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace durero::io {
namespace {

double greatest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// By how much an axis of a camera's frame may be askew or another length: frames are written with some digits.
constexpr double as_written = 1e-4;

bool is_even(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z) {
  const double length = glm::length(z), bound = as_written * length * length;
  const auto is_near = [&](double a, double b) { return std::abs(a - b) <= bound; };
  return length > 0 && std::isfinite(length) && is_near(glm::dot(x, x), length * length) &&
         is_near(glm::dot(y, y), length * length) && is_near(glm::dot(x, y), 0) && is_near(glm::dot(y, z), 0) &&
         is_near(glm::dot(z, x), 0);
}

}  // namespace

std::optional<double> vertical_angle(double degrees, AngleAcross side, scene::Resolution size) {
  const double width = size.width, height = size.height;
  double across = height;
  switch (side) {
    case AngleAcross::width:
      across = width;
      break;
    case AngleAcross::height:
      break;
    case AngleAcross::smaller:
      across = std::min(width, height);
      break;
    case AngleAcross::larger:
      across = std::max(width, height);
      break;
    case AngleAcross::diagonal:
      across = std::hypot(width, height);
      break;
  }
  if (!(degrees > 0 && degrees < 180)) return std::nullopt;
  if (across == height) return degrees;
  return glm::degrees(2 * std::atan(std::tan(glm::radians(degrees) / 2) * height / across));
}

std::optional<scene::Camera> placed_camera(const AffinePlacement& frame, double fov_y, bool is_mirrored) {
  const AffineMap linear = frame.map.linear();
  const glm::dvec3 x = linear.point({1, 0, 0}, 1), y = linear.point({0, 1, 0}, 1), z = linear.point({0, 0, 1}, 1);
  if (!is_even(x, y, z)) return std::nullopt;
  const glm::dvec3 eye = frame.map.point(glm::dvec3(0), 1);
  // A point so far ahead that its rounding is no greater than that of the direction's own numbers.
  const double from = greatest(eye), by = greatest(z);
  const int doublings = from > by ? std::ilogb(from) - std::ilogb(by) + 1 : 0;
  const glm::dvec3 ahead = frame.map.point({0, 0, std::ldexp(1, std::min(doublings, 1000))}, 1);
  const auto is_finite = [](const glm::dvec3& p) { return std::isfinite(greatest(p)); };
  if (!is_finite(eye) || !is_finite(ahead) || eye == ahead) return std::nullopt;
  scene::Camera camera{eye, ahead, y, fov_y};
  camera.mirrored = is_mirrored != (frame.map.orientation() < 0);
  return camera;
}

}  // namespace durero::io
