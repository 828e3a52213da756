#include "durero/render/bundle/cone.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "durero/scene/axes_across.hpp"

namespace durero::render {
namespace {

constexpr double pi = std::numbers::pi;

double square(double x) { return x * x; }

/// The angle at a corner of a spherical triangle, opposite to a; s is half the sum of the sides.
double angle_opposite(double a, double b, double c, double s) {
  const double far = std::sin(s) * std::sin(s - a), near = std::sin(s - b) * std::sin(s - c);
  return 2 * std::atan2(std::sqrt(std::max(0.0, near)), std::sqrt(std::max(0.0, far)));
}

/// The area of a spherical triangle of these sides (L'Huilier).
double excess(double a, double b, double c, double s) {
  const double product = std::tan(s / 2) * std::tan((s - a) / 2) * std::tan((s - b) / 2) * std::tan((s - c) / 2);
  return 4 * std::atan(std::sqrt(std::max(0.0, product)));
}

/// The place of a corner in the frame of a cone: x and y across the axis, z along it.
glm::dvec3 in_frame(const RayCone& cone, const glm::dvec3& v) {
  return {glm::dot(v, cone.first), glm::dot(v, cone.second), glm::dot(v, cone.axis)};
}

/// The area of the spherical triangle between the axis and two directions, signed by the turn from p to q.
double beside_axis(const glm::dvec3& p, const glm::dvec3& q) {
  const glm::dvec3 a = glm::normalize(p), b = glm::normalize(q);
  return 2 * std::atan2(a.x * b.y - a.y * b.x, 1 + a.z + b.z + glm::dot(a, b));
}

/// The turn about the axis from p to q.
double turn(const glm::dvec3& p, const glm::dvec3& q) {
  return std::atan2(p.x * q.y - p.y * q.x, p.x * q.x + p.y * q.y);
}

/// The part of a cone between its axis and an edge, signed.
double under_edge(const RayCone& cone, const glm::dvec3& p, const glm::dvec3& q) {
  // p + t·(q − p) lies in the cone where z > 0 and tangent²·z² − x² − y² ≥ 0.
  const glm::dvec3 way = q - p, weight(-1, -1, square(cone.tangent));
  const double a = glm::dot(way * weight, way), b = glm::dot(p * weight, way), c = glm::dot(p * weight, p);
  std::array<double, 4> cuts{0, 1, 1, 1};
  std::size_t count = 1;
  if (const double root = b * b - a * c; root > 0 && a != 0) {
    const double stable = -(b + std::copysign(std::sqrt(root), b));
    for (const double t : {stable / a, c / stable})
      if (t > 0 && t < 1) cuts[count++] = t;
  }
  std::sort(cuts.begin(), cuts.begin() + std::ptrdiff_t(count));
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double from = cuts[i], to = i + 1 < count ? cuts[i + 1] : 1;
    const glm::dvec3 begin = p + from * way, end = p + to * way, middle = p + 0.5 * (from + to) * way;
    const bool within = middle.z > 0 && glm::dot(middle * weight, middle) > 0;
    sum += within ? beside_axis(begin, end) : turn(begin, end) * (solid_angle(cone.half) / (2 * pi));
  }
  return sum;
}

}  // namespace

RayCone::RayCone(const glm::dvec3& from, const glm::dvec3& towards, double half_angle)
    : apex(from), axis(towards), half(half_angle), tangent(std::tan(half_angle)) {
  const scene::AxesAcross axes = scene::axes_across(axis);
  first = axes.first;
  second = axes.second;
}

double solid_angle(double half) { return 4 * pi * square(std::sin(half / 2)); }

double half_angle(double solid) { return 2 * std::asin(std::sqrt(solid / (4 * pi))); }

double cone_overlap(double half, double other, double between) {
  if (between >= half + other) return 0;
  if (between + half <= other) return 1;
  if (between + other <= half) return solid_angle(other) / solid_angle(half);
  // Two sectors less the two triangles that they have in common with the line between the axes, each well conditioned.
  const double s = (half + other + between) / 2;
  const double at_axis = angle_opposite(other, half, between, s), at_other = angle_opposite(half, other, between, s);
  const double lens =
      (at_axis * solid_angle(half) + at_other * solid_angle(other)) / pi - 2 * excess(half, other, between, s);
  return std::clamp(lens / solid_angle(half), 0.0, 1.0);
}

double triangle_share(const RayCone& cone, const std::array<glm::dvec3, 3>& corners) {
  const std::array<glm::dvec3, 3> at{in_frame(cone, corners[0]), in_frame(cone, corners[1]),
                                     in_frame(cone, corners[2])};
  if (at[0].z <= 0 && at[1].z <= 0 && at[2].z <= 0) return 0;
  double sum = 0, turns = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    sum += under_edge(cone, at[i], at[(i + 1) % 3]);
    turns += turn(at[i], at[(i + 1) % 3]);
  }
  const double share = std::abs(sum) / solid_angle(cone.half);
  // Edges that go once around the axis are those of a triangle before the apex, or of one that the axis meets behind
  // it.
  const glm::dvec3 across = glm::cross(at[1] - at[0], at[2] - at[0]);
  const bool behind = std::abs(turns) > pi && across.z * glm::dot(across, at[0]) < 0;
  return std::clamp(behind ? 1 - share : share, 0.0, 1.0);
}

}  // namespace durero::render
