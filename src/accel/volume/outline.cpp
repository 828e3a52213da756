#include "durero/accel/volume/outline.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "durero/surface/surfaces.hpp"

namespace durero::accel {
namespace {

using std::numbers::pi;

Outline discs(const glm::dvec3& centro, const glm::dvec3& vector, double altura, double base, double top) {
  return {.centre = {centro, centro + altura * vector},
          .radius = {base, top},
          .count = 2,
          .axis = vector,
          .ball = false,
          .size = norm_1(centro) + altura + base + top};
}

Outline of(const scene::Sphere& e) {
  return {.centre = {e.centro},
          .radius = {e.radio},
          .count = 1,
          .axis = {0, 0, 1},
          .ball = true,
          .size = norm_1(e.centro) + e.radio};
}
Outline of(const scene::Cylinder& e) { return discs(e.centro, e.vector, e.altura, e.radio, e.radio); }
Outline of(const scene::Cone& e) { return discs(e.centro, e.vector, e.altura, e.proporcion * e.altura, 0); }
Outline of(const scene::TruncatedCone& e) {
  return discs(e.centro, e.vector, e.altura, surface::radius_of_base(e), e.radio);
}
Outline of(const scene::Disc& e) {
  return {.centre = {e.centro},
          .radius = {e.radio},
          .count = 1,
          .axis = e.vector,
          .ball = false,
          .size = norm_1(e.centro) + e.radio};
}
Outline of(const scene::Plane& e) {
  return {.centre = {e.centro}, .radius = {}, .count = 1, .axis = e.vector, .ball = false, .size = 0};
}
/// The axis affects only the fit, so any unit vector serves where the normal is lost to rounding.
Outline of(const scene::Triangle& e) {
  const auto& [a, b, c] = e.vertices;
  const double scale = std::max({norm_1(b - a), norm_1(c - a), 0x1p-200});
  const glm::dvec3 normal = glm::cross((b - a) / scale, (c - a) / scale);
  const double length = glm::length(normal);
  return {.centre = {a, b, c},
          .radius = {},
          .count = 3,
          .axis = length > 0x1p-40 ? normal / length : glm::dvec3(0, 0, 1),
          .ball = false,
          .size = norm_1(a) + norm_1(b) + norm_1(c)};
}

}  // namespace

Outline outline(scene::ShapeView element) {
  return element.visit([](const auto& shape) { return of(shape); });
}

// A disc of radius r across a unit axis d reaches r·√(n² − (n·d)²) along n. Two errors change the difference by less
// than 2⁻⁴⁷ n²: d² is within 2⁻⁵⁰ of 1, and the difference is rounded; the rest is less than 2⁻⁴⁰ of r. A point of the
// disc at a height s lies s(1 − d²) beside it, less than 2⁻⁴⁹ of the size; the centre of the second disc is rounded by
// less than 4u of the size, and n·c by 4u of |n|₁ times the size, with u = 2⁻⁵³: all less than 2⁻⁴⁷.
Slab Outline::extent(const glm::dvec3& n) const {
  const double squared = glm::dot(n, n), along = ball ? 0 : glm::dot(n, axis);
  const double share = std::sqrt(std::max(0.0, squared - along * along) + 0x1p-47 * squared) * (1 + 0x1p-40);
  const double slack = 0x1p-46 * norm_1(n) * size;
  Slab slab{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < count; ++i) {
    const double at = glm::dot(n, centre[i]), reach = radius[i] * share + slack;
    slab.low = std::min(slab.low, at - reach);
    slab.high = std::max(slab.high, at + reach);
  }
  return slab;
}

double Outline::surface() const {
  if (ball) return 4 * pi * radius[0] * radius[0];
  if (count == 1) return 2 * pi * radius[0] * radius[0];
  if (count == 3) return glm::length(glm::cross(centre[1] - centre[0], centre[2] - centre[0]));
  const double height = glm::length(centre[1] - centre[0]), slant = std::hypot(height, radius[0] - radius[1]);
  return pi * (radius[0] * radius[0] + radius[1] * radius[1] + (radius[0] + radius[1]) * slant);
}

// Seen along v, at an angle of cosine c to the axis, discs are ellipses that are narrower by c along the axis.
// Stretched back, they are circles, whose hull is two arcs and the tangents to both.
double Outline::projected(const glm::dvec3& v) const {
  const double r = radius[0], s = radius[1];
  if (ball) return pi * r * r;
  if (count == 3) return std::abs(glm::dot(glm::cross(centre[1] - centre[0], centre[2] - centre[0]), v)) / 2;
  const double cosine = std::abs(glm::dot(axis, v));
  if (count == 1) return pi * r * r * cosine;
  const double apart = glm::length(glm::cross(centre[1] - centre[0], v));
  if (cosine < 1e-9) return (r + s) * apart;
  const double distance = apart / cosine;
  if (distance <= std::abs(r - s)) return pi * std::max(r, s) * std::max(r, s) * cosine;
  const double angle = std::acos((r - s) / distance);
  return (r * r * (pi - angle) + s * s * angle + (r + s) * distance * std::sin(angle)) * cosine;
}

}  // namespace durero::accel
