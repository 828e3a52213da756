#include "durero/render/sample/maps.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace durero::render {
namespace {

using std::numbers::pi;

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
  if (p == glm::dvec2(0)) return p;
  const bool is_wide = std::abs(p.x) > std::abs(p.y);
  const double radius = is_wide ? p.x : p.y;
  const double turn = is_wide ? pi / 4 * (p.y / p.x) : pi / 2 - pi / 4 * (p.x / p.y);
  return radius * glm::dvec2(std::cos(turn), std::sin(turn));
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
