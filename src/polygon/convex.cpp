#include "durero/polygon/convex.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace durero::polygon {

RationalPoint exact(const glm::dvec3& point) {
  return {number::exact(point.x), number::exact(point.y), number::exact(point.z)};
}

glm::dvec3 rounded(const RationalPoint& point) {
  return {number::round_to_binary64(point.x), number::round_to_binary64(point.y), number::round_to_binary64(point.z)};
}

RationalPoint operator+(const RationalPoint& a, const RationalPoint& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
RationalPoint operator-(const RationalPoint& a, const RationalPoint& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
RationalPoint operator*(const Rational& s, const RationalPoint& a) { return {s * a.x, s * a.y, s * a.z}; }
Rational dot(const RationalPoint& a, const RationalPoint& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

PlaneSide opposite(const PlaneSide& half) { return {Rational(-1) * half.normal, -half.offset}; }

RationalPoint doubled_area(const Polygon& polygon) {
  RationalPoint sum{};
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum = sum + cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  return sum;
}

bool contains(const Polygon& polygon, const RationalPoint& w) {
  const RationalPoint across = doubled_area(polygon);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint& a = polygon[i];
    if (dot(cross(polygon[(i + 1) % polygon.size()] - a, w - a), across) < 0) return false;
  }
  return polygon.size() >= 3;
}

PolygonParts split(const Polygon& polygon, const PlaneSide& half) {
  if (polygon.empty()) return {};
  std::vector<Rational> depths;
  for (const RationalPoint& corner : polygon) depths.push_back(half.depth(corner));
  const auto [least, greatest] = std::minmax_element(depths.begin(), depths.end());
  if (*greatest <= 0) return {{}, polygon};
  if (*least >= 0) return {polygon, {}};
  PolygonParts cut;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = (i + 1) % polygon.size();
    if (depths[i] >= 0) cut.inside.push_back(polygon[i]);
    if (depths[i] <= 0) cut.outside.push_back(polygon[i]);
    if (depths[i].sign() * depths[next].sign() >= 0) continue;
    const RationalPoint on = polygon[i] + (depths[i] / (depths[i] - depths[next])) * (polygon[next] - polygon[i]);
    cut.inside.push_back(on);
    cut.outside.push_back(on);
  }
  return cut;
}

Polygon clipped(Polygon polygon, std::span<const PlaneSide> body) {
  for (const PlaneSide& half : body) polygon = split(polygon, half).inside;
  return polygon;
}

std::vector<Polygon> without(const Polygon& polygon, std::span<const PlaneSide> body) {
  if (clipped(polygon, body).empty()) return {polygon};
  std::vector<Polygon> outside;
  Polygon rest = polygon;
  for (const PlaneSide& half : body) {
    PolygonParts cut = split(rest, half);
    if (!cut.outside.empty()) outside.push_back(std::move(cut.outside));
    rest = std::move(cut.inside);
  }
  return outside;
}

}  // namespace durero::polygon
