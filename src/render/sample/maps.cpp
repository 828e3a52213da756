#include "durero/render/sample/maps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace durero::render {
namespace {

using std::numbers::pi;

/// The sum of the terms times the powers of q, the highest first.
template <std::size_t count>
double series(const std::array<double, count>& terms, double q) {
  double sum = 0;
  for (const double term : terms) sum = sum * q + term;
  return sum;
}

/// The cosine and the sine of an angle t of at most π/4, by nine and eight terms of their series. The terms left out
/// are less than t¹⁸/18! < 2⁻⁵⁸ and t¹⁷/17! < 2⁻⁵⁴. Libraries differ in the last digit, and take longer.
glm::dvec2 cosine_and_sine(double t) {
  static constexpr std::array even{1 / 20922789888000.0,
                                   1 / 87178291200.0,
                                   1 / 479001600.0,
                                   1 / 3628800.0,
                                   1 / 40320.0,
                                   1 / 720.0,
                                   1 / 24.0,
                                   1 / 2.0,
                                   1.0};  // 16!, 14!, … 0!
  static constexpr std::array odd{1 / 1307674368000.0, 1 / 6227020800.0, 1 / 39916800.0, 1 / 362880.0,
                                  1 / 5040.0,          1 / 120.0,        1 / 6.0,        1.0};  // 15!, 13!, … 1!
  return {series(even, -t * t), t * series(odd, -t * t)};
}

/// The direction about an axis whose angle has that versine, turned by a share of a whole turn.
glm::dvec3 about(const glm::dvec3& axis, double versine, double share_of_turn) {
  const auto [u, v] = across(axis);
  const double sine = std::sqrt(std::max(0.0, versine * (2 - versine))), turn = 2 * pi * share_of_turn;
  return (1 - versine) * axis + sine * (std::cos(turn) * u + std::sin(turn) * v);
}

}  // namespace

/// The branchless frame of Duff and others (*Building an Orthonormal Basis, Revisited*, 2017).
std::array<glm::dvec3, 2> across(const glm::dvec3& n) {
  const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  return {glm::dvec3{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, glm::dvec3{b, sign + n.y * n.y * a, -n.y}};
}

glm::dvec2 in_disc(const glm::dvec2& pair) {
  const glm::dvec2 p = 2.0 * pair - 1.0;
  const bool is_wide = std::abs(p.x) > std::abs(p.y);
  const double radius = is_wide ? p.x : p.y, other = is_wide ? p.y : p.x;
  if (radius == 0) return p;
  const glm::dvec2 turned = cosine_and_sine(pi / 4 * (other / radius));
  return radius * (is_wide ? turned : glm::dvec2(turned.y, turned.x));
}

glm::dvec3 on_sphere(const glm::dvec2& pair) { return about({0, 0, 1}, 2 * pair.x, pair.y); }

glm::dvec2 in_triangle(const glm::dvec2& pair) {
  const double root = std::sqrt(pair.x);
  return {root * (1 - pair.y), root * pair.y};
}

glm::dvec3 by_cosine(const glm::dvec2& pair, const glm::dvec3& normal) {
  const glm::dvec2 foot = in_disc(pair);
  const auto [u, v] = across(normal);
  return foot.x * u + foot.y * v + std::sqrt(std::max(0.0, 1 - glm::dot(foot, foot))) * normal;
}

double cosine_density(double cosine) { return std::max(0.0, cosine) / pi; }

glm::dvec3 in_lobe(const glm::dvec2& pair, const glm::dvec3& axis, double exponent) {
  if (std::isinf(exponent)) return axis;
  // The share x of the lobe lies nearer to the axis than the angle of cosine (1 − x)^(1/(exponent + 1)).
  return about(axis, -std::expm1(std::log1p(-pair.x) / (exponent + 1)), pair.y);
}

double lobe_density(double cosine, double exponent) {
  return cosine > 0 ? (exponent + 1) / (2 * pi) * std::pow(cosine, exponent) : 0;
}

glm::dvec3 in_cone(const glm::dvec2& pair, const glm::dvec3& axis, double versine) {
  return about(axis, versine * pair.x, pair.y);
}

}  // namespace durero::render
