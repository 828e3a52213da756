#include "durero/accel/volume/round.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace durero::accel {
namespace {

/// Tests the ray q + t·v against the ball of that radius about 0, by the steps and allowances of trace/filter.hpp. Most
/// rays miss, which is known without the root.
VolumeTest round(const glm::dvec3& q, const glm::dvec3& v, double radius, double limit) {
  const double length_squared = glm::dot(v, v) * (1 + 0x1p-47 + 0x1p-50);
  const glm::dvec3 moment = glm::cross(q, v);
  if (!(glm::dot(moment, moment) <= radius * radius * length_squared)) return VolumeTest::missed;
  const double B = glm::dot(q, v), reach = radius * std::sqrt(length_squared);
  if (B > reach) return VolumeTest::missed;
  return B + reach + limit * length_squared >= 0 ? VolumeTest::met : VolumeTest::beyond;
}

glm::dvec3 stretched(const Ellipsoid& ellipsoid, const glm::dvec3& x) {
  return x + (ellipsoid.lambda - 1) * glm::dot(x, ellipsoid.axis) * ellipsoid.axis;
}

}  // namespace

VolumeTest verdict(const surface::Ball& ball, const trace::Ray& ray, double limit) {
  return round(ray.p - ball.centre, ray.v, ball.radius + 0x1p-49 * norm_1(ball.centre) + ray.allowance(), limit);
}

VolumeTest verdict(const Ellipsoid& ellipsoid, const trace::Ray& ray, double limit) {
  const double longer = std::max(1.0, ellipsoid.lambda), ratio = longer / std::min(1.0, ellipsoid.lambda);
  const double far = longer * (norm_1(ray.p) + norm_1(ellipsoid.centre));
  // The allowance includes 16u of the origin, as a ball's does.
  const double radius = ellipsoid.rho + 0x1p-45 * ratio * (ellipsoid.rho + far) + 0x1p-48 * far;
  return round(stretched(ellipsoid, ray.p - ellipsoid.centre), stretched(ellipsoid, ray.v), radius, limit);
}

// Of a cylinder of radius r and half height h the least ellipsoid has the radius r·√(3/2) across its axis and h·√3
// along it: λ = (r/h)/√2. A point of a disc about c, with s = (c − centre)·d and e the part of c − centre across the
// axis, is at most √((|e| + r)² + λ²s²) from the centre where the axis is stretched; points between the discs are
// nearer. Each step errs by less than 2⁻⁴⁰ of its result, but for c, s and e: less than 2⁻⁴⁷ of the size, and Λ times
// that where it is stretched.
Ellipsoid ellipsoid_around(const Outline& outline) {
  Ellipsoid result{outline.centre[0], outline.axis, 1, outline.radius[0]};
  if (outline.ball) return result;
  glm::dvec3 low = outline.centre[0], high = low;
  for (std::size_t i = 1; i < outline.count; ++i)
    low = glm::min(low, outline.centre[i]), high = glm::max(high, outline.centre[i]);
  result.centre = 0.5 * low + 0.5 * high;
  const auto each = [&](auto take) {
    for (std::size_t i = 0; i < outline.count; ++i) {
      const glm::dvec3 x = outline.centre[i] - result.centre;
      const double along = glm::dot(x, outline.axis);
      take(std::abs(along), glm::length(x - along * outline.axis) + outline.radius[i]);
    }
  };
  double half_height = 0, radius = 0;
  each([&](double along, double across) {
    half_height = std::max(half_height, along);
    radius = std::max(radius, across);
  });
  result.lambda = std::clamp(radius / (half_height * std::sqrt(2.0)), 0x1p-10, 0x1p10);
  double rho = 0;
  each([&](double along, double across) { rho = std::max(rho, std::hypot(across, result.lambda * along)); });
  result.rho = rho * (1 + 0x1p-40) + 0x1p-45 * std::max(1.0, result.lambda) * outline.size;
  return result;
}

}  // namespace durero::accel
