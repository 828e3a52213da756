#include "durero/surface/bounds.hpp"

#include <algorithm>
#include <cmath>

namespace durero::surface {
namespace {

double extent(const glm::dvec3& x) { return std::abs(x.x) + std::abs(x.y) + std::abs(x.z); }

}  // namespace

// The best centre is the height on the axis from which both rims are equally far. A point of a rim of radius r at the
// advance s has the squared distance r² + (s − height)² from the axis's point at the height, and all points between the
// two discs are nearer than the farther rim. The radius is computed for the height as it was rounded. With w − centro =
// s·d + e, d² within 2⁻⁵⁰ of 1 and e·d of s times that, squared distances from the axis's point are those of a unit
// axis up to 2⁻⁴⁷ of them: the factor pays for that and for rounding. The rounded centre is off by at most 4u(|centro|
// + height) in each component.
Ball ball_of_discs(const glm::dvec3& centro, const glm::dvec3& vector, double altura, double base, double top) {
  const double height = std::clamp((altura + (top - base) / altura * (top + base)) / 2, 0.0, altura);
  const double beyond = altura - height;
  const double radius = std::max(std::sqrt(base * base + height * height), std::sqrt(top * top + beyond * beyond));
  return {centro + height * vector, radius * (1 + 0x1p-40) + 0x1p-48 * (extent(centro) + height)};
}

// A disc of radius r across a unit axis d reaches r·√(1 − dᵢ²) along the axis i of space. Three errors change 1 − dᵢ²
// by less than 2⁻⁴⁷ and the rest by less than 2⁻⁴⁰ of r: d² is within 2⁻⁵⁰ of 1, e·d is of s times that, and the
// roundings below. The ends are rounded as the centre of a ball is.
Box box_of_discs(const glm::dvec3& centro, const glm::dvec3& vector, double altura, double base, double top) {
  Box box{};
  const double slack = 0x1p-48 * (extent(centro) + altura);
  for (int i = 0; i < 3; ++i) {
    const double share = std::sqrt(std::max(0.0, 1 - vector[i] * vector[i]) + 0x1p-47) * (1 + 0x1p-40);
    const double end = centro[i] + altura * vector[i];
    box.low[i] = std::min(centro[i] - base * share, end - top * share) - slack;
    box.high[i] = std::max(centro[i] + base * share, end + top * share) + slack;
  }
  return box;
}

}  // namespace durero::surface
