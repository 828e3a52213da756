#include "durero/polygon/pyramid.hpp"

#include <cstddef>

namespace durero::polygon {
namespace {

/// The half-space through the apex and two corners, with the corner `inside` in it.
PlaneSide through(const Apex& apex, const RationalPoint& a, const RationalPoint& b, const RationalPoint& inside) {
  const RationalPoint normal = cross(b - a, apex.far ? apex.at : apex.at - a);
  const PlaneSide half{normal, dot(normal, a)};
  return half.depth(inside) < 0 ? opposite(half) : half;
}

}  // namespace

std::optional<PlaneSide> side_of(const Apex& apex, const Polygon& polygon) {
  const RationalPoint normal = doubled_area(polygon);
  const PlaneSide half{normal, dot(normal, polygon[0])};
  const int side = apex.depth_in(half).sign();
  if (side == 0) return std::nullopt;
  return side < 0 ? opposite(half) : half;
}

std::vector<PlaneSide> pyramid(const Apex& apex, const Polygon& polygon) {
  std::vector<PlaneSide> sides;
  if (!side_of(apex, polygon)) return sides;
  RationalPoint sum{};  // corners may lie on one line, but their middle lies on no edge
  for (const RationalPoint& corner : polygon) sum = sum + corner;
  const RationalPoint middle = (1 / Rational(polygon.size())) * sum;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sides.push_back(through(apex, polygon[i], polygon[(i + 1) % polygon.size()], middle));
  return sides;
}

std::vector<PlaneSide> hidden(const Apex& apex, const Polygon& polygon) {
  std::vector<PlaneSide> body = pyramid(apex, polygon);
  if (!body.empty()) body.push_back(opposite(*side_of(apex, polygon)));
  return body;
}

std::optional<RationalPoint> projected(const Apex& apex, const RationalPoint& w, const PlaneSide& plane) {
  const RationalPoint along = apex.far ? Rational(-1) * apex.at : w - apex.at;
  const Rational slope = dot(plane.normal, along);
  if (slope == 0) return std::nullopt;
  const Rational t = -plane.depth(w) / slope;  // from w; the ray starts at −1, or without end
  if (!apex.far && t <= -1) return std::nullopt;
  return w + t * along;
}

}  // namespace durero::polygon
