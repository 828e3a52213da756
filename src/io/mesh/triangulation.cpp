#include "triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "constraints.hpp"
#include "delaunay.hpp"

namespace durero::io {
namespace {

using Edge = PlanarEdges::Edge;
using Point = PlanePoints::Number;

/// The axes by how much the polygon faces them, most first: by the size of its normal there, the sum of the products
/// over its edges (Newell). What rounding does to the sums changes the order at most, and with it which of the right
/// triangulations is found.
std::array<int, 3> axes_faced(std::span<const glm::dvec3> polygon) {
  using Wide = long double;  // its exponents keep the products from overflow
  std::array<Wide, 3> normal{};
  const glm::dvec3& first = polygon.front();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const auto along = [&](std::size_t vertex, int axis) { return Wide{polygon[vertex][axis]} - Wide{first[axis]}; };
    for (int axis = 0; axis < 3; ++axis) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      normal[static_cast<std::size_t>(axis)] += along(i, u) * along(i + 1, v) - along(i, v) * along(i + 1, u);
    }
  }
  std::array axes{0, 1, 2};
  std::ranges::stable_sort(axes, std::ranges::greater{},
                           [&](int axis) { return std::abs(normal[static_cast<std::size_t>(axis)]); });
  return axes;
}

/// The polygon as it is seen along an axis.
PlanePoints seen_along(int axis, std::span<const glm::dvec3> polygon) {
  std::vector<glm::dvec2> points;
  points.reserve(polygon.size());
  for (const glm::dvec3& p : polygon) points.emplace_back(p[(axis + 1) % 3], p[(axis + 2) % 3]);
  return PlanePoints(std::move(points));
}

/// The triangles of a polygon that is seen as a simple one; nothing of another.
class PolygonCut {
 public:
  explicit PolygonCut(const PlanePoints& points) : points_(points), count_(static_cast<Point>(points.size())) {}

  std::optional<std::vector<CornerNumbers>> triangles() const {
    std::vector<Point> by_place(count_);
    std::iota(by_place.begin(), by_place.end(), Point{0});
    std::ranges::sort(by_place, [&](Point a, Point b) { return points_.is_before(a, b); });
    if (std::ranges::adjacent_find(by_place, [&](Point a, Point b) { return points_.are_one(a, b); }) != by_place.end())
      return std::nullopt;
    PlanarEdges edges = delaunay_edges(points_, by_place);
    for (Point i = 0; i < count_; ++i)
      if (!constrain(edges, points_, i, following(i))) return std::nullopt;
    return inner_triangles(edges, by_place.front());
  }

 private:
  Point following(Point i) const { return i + 1 == count_ ? 0 : i + 1; }
  Point preceding(Point i) const { return i == 0 ? count_ - 1 : i - 1; }

  /// The first point is a corner of the hull, where the polygon turns as it goes round. From inside no fixed edge is
  /// met but the polygon's.
  std::vector<CornerNumbers> inner_triangles(const PlanarEdges& edges, Point first) const {
    const bool clockwise = points_.turn(preceding(first), first, following(first)) < 0;
    std::vector<CornerNumbers> triangles;
    std::vector<bool> reached(edges.count());  // the face to the left
    std::vector<Edge> inner{edge_inside(edges, first, clockwise ? preceding(first) : following(first))};
    while (!inner.empty()) {
      const Edge e = inner.back();
      inner.pop_back();
      if (reached[e]) continue;
      triangles.push_back(corners_of(edges, e, clockwise));
      for (const Edge side : {e, edges.next(e), edges.previous(e)}) {
        reached[side] = true;
        if (!edges.is_fixed(side)) inner.push_back(PlanarEdges::twin(side));
      }
    }
    std::ranges::sort(triangles);
    return triangles;
  }

  /// The edge between two neighbours, in the direction that has the polygon to its left.
  static Edge edge_inside(const PlanarEdges& edges, Point from, Point to) {
    Edge e = edges.leaving(from);
    while (edges.target(e) != to) e = edges.after(e);
    return e;
  }

  /// The corners of the face to the left, in the polygon's direction and the least of them first.
  static CornerNumbers corners_of(const PlanarEdges& edges, Edge e, bool clockwise) {
    CornerNumbers corners{edges.origin(e), edges.target(e), edges.apex(e)};
    if (clockwise) std::swap(corners[1], corners[2]);
    std::ranges::rotate(corners, std::ranges::min_element(corners));
    return corners;
  }

  const PlanePoints& points_;
  Point count_;
};

}  // namespace

std::optional<std::vector<CornerNumbers>> triangulated(std::span<const glm::dvec3> polygon, std::uint64_t* decisions) {
  if (polygon.size() == 3) return std::vector{CornerNumbers{0, 1, 2}};
  for (const int axis : axes_faced(polygon)) {
    const PlanePoints points = seen_along(axis, polygon);
    auto triangles = PolygonCut(points).triangles();
    if (decisions != nullptr) *decisions += points.decisions();
    if (triangles) return triangles;
  }
  return std::nullopt;
}

}  // namespace durero::io
