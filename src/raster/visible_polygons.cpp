#include "durero/raster/visible_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "durero/raster/scene_polygons.hpp"

namespace durero::raster {
namespace {

using polygon::Polygon;

constexpr double everywhere = std::numeric_limits<double>::infinity();

/// The half-spaces of a body in binary64, which tell of most polygons that they have nothing in it.
class BodyInDoubles {
 public:
  explicit BodyInDoubles(const std::vector<polygon::PlaneSide>& body) {
    for (const polygon::PlaneSide& side : body) {
      const polygon::RationalPoint& n = side.normal;
      const polygon::Rational size = std::max({abs(n.x), abs(n.y), abs(n.z)});
      sides_.push_back({rounded((1 / size) * n), number::round_to_binary64(side.offset / size)});
    }
  }

  /// Whether all corners certainly lie outside of one of the half-spaces. The four sizes that are summed are wrong by
  /// at most eight roundings each.
  bool is_apart(const std::vector<glm::dvec3>& corners) const {
    return std::ranges::any_of(sides_, [&](const auto& side) {
      return std::ranges::all_of(corners, [&](const glm::dvec3& corner) {
        const glm::dvec3 each = side.normal * corner;
        const double sizes = std::abs(each.x) + std::abs(each.y) + std::abs(each.z) + std::abs(side.offset);
        return each.x + each.y + each.z - side.offset < -sizes * 0x1p-50;
      });
    });
  }

 private:
  struct Side {
    glm::dvec3 normal;
    double offset;
  };
  std::vector<Side> sides_;
};

std::vector<glm::dvec3> rounded_corners(const Polygon& corners) {
  std::vector<glm::dvec3> all;
  for (const polygon::RationalPoint& corner : corners) all.push_back(rounded(corner));
  return all;
}

/// The distance of a point and a polygon: to its plane where the foot lies within, else to the nearest edge.
double distance_to(const Polygon& corners, const glm::dvec3& point) {
  const glm::dvec3 across = glm::normalize(rounded(polygon::doubled_area(corners)));
  const double height = glm::dot(rounded(corners[0]) - point, across);
  if (polygon::contains(corners, polygon::exact(point + height * across))) return std::abs(height);
  double least = everywhere;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 a = rounded(corners[i]), edge = rounded(corners[(i + 1) % corners.size()]) - a;
    const double along = std::clamp(glm::dot(point - a, edge) / glm::dot(edge, edge), 0.0, 1.0);
    least = std::min(least, glm::distance(point, a + along * edge));
  }
  return least;
}

/// How near the apex a polygon comes; of a far one, how far it reaches towards it, turned around. It decides how many
/// cuts are made and nothing else.
double depth_of(const Polygon& corners, const polygon::Apex& apex) {
  const glm::dvec3 at = rounded(apex.at);
  if (!apex.far) return distance_to(corners, at);
  double least = everywhere;
  for (const polygon::RationalPoint& corner : corners) least = std::min(least, -glm::dot(rounded(corner), at));
  return least;
}

std::vector<std::size_t> by_depth(std::span<const Polygon> polygons, const polygon::Apex& apex) {
  std::vector<double> depths;
  for (const Polygon& corners : polygons) depths.push_back(depth_of(corners, apex));
  std::vector<std::size_t> order(polygons.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return depths[i]; });
  return order;
}

/// A part that is left of a polygon, and its corners in binary64.
struct LeftPart {
  Polygon corners;
  std::vector<glm::dvec3> rounded;
};

}  // namespace

VisiblePolygons visible_polygons(std::span<const Polygon> polygons, const polygon::Apex& apex) {
  std::vector<std::vector<LeftPart>> left;
  for (const Polygon& corners : polygons) left.push_back({{corners, rounded_corners(corners)}});
  VisiblePolygons visible;
  for (const std::size_t nearer : by_depth(polygons, apex)) {
    const auto body = polygon::hidden(apex, polygons[nearer]);
    if (left[nearer].empty() || body.empty()) continue;
    const BodyInDoubles quick(body);
    for (std::size_t farther = 0; farther < polygons.size(); ++farther) {
      if (farther == nearer) continue;
      std::vector<LeftPart> kept;
      for (LeftPart& part : left[farther]) {
        if (quick.is_apart(part.rounded)) {
          kept.push_back(std::move(part));
          continue;
        }
        ++visible.clips;
        for (Polygon& piece : polygon::without(part.corners, body)) {
          std::vector<glm::dvec3> places = rounded_corners(piece);
          kept.push_back({std::move(piece), std::move(places)});
        }
      }
      left[farther] = std::move(kept);
    }
  }
  for (std::vector<LeftPart>& parts : left) {
    visible.parts.emplace_back();
    for (LeftPart& part : parts) visible.parts.back().push_back(std::move(part.corners));
  }
  return visible;
}

}  // namespace durero::raster
