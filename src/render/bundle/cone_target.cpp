#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "cone_cover.hpp"

namespace durero::render {
namespace {

/// The cone of all directions in which a sphere or a plane is seen: its axis, and its half-angle.
struct SeenCone {
  glm::dvec3 axis;
  double half;
};

SeenCone seen_cone(const scene::Sphere& sphere, const glm::dvec3& from) {
  const glm::dvec3 to = sphere.centro - from;
  const double distance = glm::length(to);
  if (distance <= sphere.radio) return {glm::dvec3(1, 0, 0), std::numbers::pi};  // seen all around
  return {to / distance, std::asin(sphere.radio / distance)};
}
SeenCone seen_cone(const scene::Plane& plane, const glm::dvec3& from) {
  const double height = glm::dot(from - plane.centro, plane.vector);
  return {height > 0 ? -plane.vector : plane.vector, std::numbers::pi / 2};
}

double angle(const glm::dvec3& a, const glm::dvec3& b) {
  return 2 * std::atan2(glm::length(a - b), glm::length(a + b));
}

double share_of(const auto& round, const RayCone& cone) {
  const SeenCone seen = seen_cone(round, cone.apex);
  return seen.half > 3 ? 1 : cone_overlap(cone.half, seen.half, angle(cone.axis, seen.axis));
}

/// The middle of the overlap of two circles, on the line between their centres.
glm::dvec2 middle_of(const auto& round, const RayCone& cone) {
  const SeenCone seen = seen_cone(round, cone.apex);
  const double between = angle(cone.axis, seen.axis);
  const glm::dvec2 towards(glm::dot(seen.axis, cone.first), glm::dot(seen.axis, cone.second));
  if (seen.half > 3 || !(glm::length(towards) > 0)) return {0, 0};
  const double low = std::max(-cone.half, between - seen.half), high = std::min(cone.half, between + seen.half);
  return std::tan((low + high) / 2) * glm::normalize(towards);
}

std::array<glm::dvec3, 3> corners_from(const scene::Triangle& triangle, const glm::dvec3& apex) {
  return {triangle.vertices[0] - apex, triangle.vertices[1] - apex, triangle.vertices[2] - apex};
}

/// The planes through the apex and each edge, which have a direction of the triangle on their positive side.
std::array<glm::dvec3, 3> sides_of(const std::array<glm::dvec3, 3>& corners) {
  const double volume = glm::dot(corners[0], glm::cross(corners[1], corners[2]));
  std::array<glm::dvec3, 3> sides;
  for (std::size_t i = 0; i < 3; ++i)
    sides[i] = std::copysign(1.0, volume) * glm::cross(corners[i], corners[(i + 1) % 3]);
  return sides;
}

/// The mean of the corners of the part that is in the cone, and of where its edges cross the cone.
glm::dvec2 middle_of(const scene::Triangle& triangle, const RayCone& cone) {
  const std::array<glm::dvec3, 3> corners = corners_from(triangle, cone.apex), sides = sides_of(corners);
  glm::dvec2 sum(0);
  int count = 0;
  const auto add = [&](const glm::dvec2& at) {
    sum += at;
    ++count;
  };
  const auto flat = [&](const glm::dvec3& v) {
    return glm::dvec2(glm::dot(v, cone.first), glm::dot(v, cone.second)) / glm::dot(v, cone.axis);
  };
  // The points of the rim that lie within, and corners within the rim; the rim is taken at 64 places.
  constexpr int places = 64;
  for (int i = 0; i < places; ++i) {
    const double turn = 2 * std::numbers::pi * i / places;
    const glm::dvec2 at = cone.tangent * glm::dvec2(std::cos(turn), std::sin(turn));
    const glm::dvec3 d = cone.direction(at);
    if (std::ranges::all_of(sides, [&](const glm::dvec3& side) { return glm::dot(side, d) >= 0; })) add(at);
  }
  for (const glm::dvec3& corner : corners)
    if (glm::dot(corner, cone.axis) > 0 && glm::length(flat(corner)) <= cone.tangent) add(flat(corner));
  return count > 0 ? sum / double(count) : glm::dvec2(0);
}
double share_of(const scene::Triangle& triangle, const RayCone& cone) {
  return triangle_share(cone, corners_from(triangle, cone.apex));
}

/// The x with a + b·x ≥ 0, within a stretch.
void clip(std::array<double, 2>& stretch, double a, double b) {
  if (b > 0)
    stretch[0] = std::max(stretch[0], -a / b);
  else if (b < 0)
    stretch[1] = std::min(stretch[1], -a / b);
  else if (a < 0)
    stretch[1] = -infinity;
}

using Stretch = std::array<double, 2>;

Stretch stretch_of(const scene::Plane& plane, const RayCone& cone, double y) {
  const glm::dvec3 axis = seen_cone(plane, cone.apex).axis;
  Stretch all{-infinity, infinity};
  clip(all, glm::dot(axis, cone.axis + y * cone.second), glm::dot(axis, cone.first));
  return all;
}
Stretch stretch_of(const scene::Triangle& triangle, const RayCone& cone, double y) {
  Stretch all{-infinity, infinity};
  for (const glm::dvec3& side : sides_of(corners_from(triangle, cone.apex)))
    clip(all, glm::dot(side, cone.axis + y * cone.second), glm::dot(side, cone.first));
  return all;
}
Stretch stretch_of(const scene::Sphere& sphere, const RayCone& cone, double y) {
  // With q to the centre and d = k + x·e the direction, it is met where (q·d)² ≥ (q² − r²)·d² and q·d > 0.
  const glm::dvec3 q = sphere.centro - cone.apex, k = cone.axis + y * cone.second;
  const double outside = glm::dot(q, q) - sphere.radio * sphere.radio;
  if (outside <= 0) return {-infinity, infinity};
  const double along = glm::dot(q, k), slope = glm::dot(q, cone.first);
  const double a = slope * slope - outside, b = along * slope, c = along * along - outside * glm::dot(k, k);
  const double root = b * b - a * c;
  if (a < 0) {
    if (!(root > 0)) return {infinity, -infinity};
    const Stretch met{(-b + std::sqrt(root)) / a, (-b - std::sqrt(root)) / a};
    return along + slope * 0.5 * (met[0] + met[1]) > 0 ? met : Stretch{infinity, -infinity};
  }
  // The circle opens beyond the plane of the frame: what is met is one side of the greater or of the lesser root.
  const double stable = -(b + std::copysign(std::sqrt(std::max(0.0, root)), b));
  const double one = a > 0 ? stable / a : stable, two = stable != 0 ? c / stable : one;
  return slope > 0 ? Stretch{std::max(one, two), infinity} : Stretch{-infinity, std::min(one, two)};
}

double parameter_of(const glm::dvec3& normal, const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& d,
                    double start) {
  const double t = glm::dot(point - from, normal) / glm::dot(d, normal);
  return t > start ? t : infinity;
}
double parameter_of(const scene::Plane& plane, const glm::dvec3& from, const glm::dvec3& d, double start) {
  return parameter_of(plane.vector, plane.centro, from, d, start);
}
double parameter_of(const scene::Triangle& triangle, const glm::dvec3& from, const glm::dvec3& d, double start) {
  const auto& [a, b, c] = triangle.vertices;
  return parameter_of(glm::cross(b - a, c - a), a, from, d, start);
}
double parameter_of(const scene::Sphere& sphere, const glm::dvec3& from, const glm::dvec3& d, double start) {
  // A direction at the rim may just miss it by rounding: it is then taken to touch it.
  const glm::dvec3 q = sphere.centro - from;
  const double squared = glm::dot(d, d), along = glm::dot(q, d);
  const double root =
      std::sqrt(std::max(0.0, along * along - squared * (glm::dot(q, q) - sphere.radio * sphere.radio)));
  for (const double t : {(along - root) / squared, (along + root) / squared})
    if (t > start) return t;
  return infinity;
}

}  // namespace

double ConeTarget::share(const RayCone& cone) const {
  return std::visit([&](const auto& shape) { return share_of(shape, cone); }, shape_);
}

glm::dvec2 ConeTarget::middle(const RayCone& cone) const {
  return std::visit([&](const auto& shape) { return middle_of(shape, cone); }, shape_);
}

std::optional<std::array<double, 2>> ConeTarget::stretch(const RayCone& cone, double y) const {
  const Stretch met = std::visit([&](const auto& shape) { return stretch_of(shape, cone, y); }, shape_);
  if (met[0] < met[1]) return met;
  return std::nullopt;
}

double ConeTarget::parameter(const glm::dvec3& from, const glm::dvec3& direction, double start) const {
  return std::visit([&](const auto& shape) { return parameter_of(shape, from, direction, start); }, shape_);
}

}  // namespace durero::render
