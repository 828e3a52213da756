#include "triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

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

  std::optional<std::vector<CornerNumbers>> triangles() {
    std::vector<Point> by_place(count_);
    std::iota(by_place.begin(), by_place.end(), Point{0});
    std::ranges::stable_sort(by_place, [&](Point a, Point b) { return points_.is_before(a, b); });
    const bool has_seams = merge_equal_points(by_place);
    if (!find_border(has_seams)) return std::nullopt;
    PlanarEdges edges = delaunay_edges(points_, by_place);
    for (Point i = 0; i < count_; ++i)
      if (following_[i] != i && !constrain(edges, points_, i, following_[i])) return std::nullopt;
    return inner_triangles(edges, by_place.front());
  }

 private:
  /// Leaves one vertex of those at each place, the first, and notes for all which one stands there. Whether some place
  /// has several.
  bool merge_equal_points(std::vector<Point>& by_place) {
    at_place_.resize(count_);
    std::vector<Point> places;
    for (const Point i : by_place) {
      if (places.empty() || !points_.are_one(places.back(), i)) places.push_back(i);
      at_place_[i] = places.back();
    }
    const bool has_equal = places.size() < by_place.size();
    by_place = std::move(places);
    return has_equal;
  }

  /// Finds the vertices before and behind each, without the seams: edges that go there and back, by which a polygon
  /// comes to the borders of its holes. False where it touches itself otherwise.
  bool find_border(bool has_seams) {
    following_.resize(count_);
    preceding_.resize(count_);
    std::iota(following_.begin(), following_.end(), Point{0});
    preceding_ = following_;
    std::set<std::pair<Point, Point>> seams;
    const auto edge = [&](Point i) { return std::pair(at_place_[i], at_place_[i + 1 == count_ ? 0 : i + 1]); };
    if (has_seams)
      for (Point i = 0; i < count_; ++i) seams.insert(edge(i));
    for (Point i = 0; i < count_; ++i) {
      const auto [from, to] = edge(i);
      if (from == to) return false;
      if (seams.contains({to, from})) continue;
      if (following_[from] != from || preceding_[to] != to) return false;
      following_[from] = to;
      preceding_[to] = from;
    }
    return true;
  }

  /// The first point is a corner of the hull, where the polygon turns as it goes round. From inside no fixed edge is
  /// met but the polygon's. Nothing where a hole is outside, or goes round as the polygon does, or where a seam leads
  /// outside.
  std::optional<std::vector<CornerNumbers>> inner_triangles(const PlanarEdges& edges, Point first) const {
    if (following_[first] == first) return std::nullopt;  // also where all edges are seams
    const bool clockwise = points_.turn(preceding_[first], first, following_[first]) < 0;
    std::vector<CornerNumbers> triangles;
    std::vector<bool> reached(edges.count());  // the face to the left
    std::vector<Edge> inner{edge_inside(edges, first, clockwise ? preceding_[first] : following_[first])};
    while (!inner.empty()) {
      const Edge e = inner.back();
      inner.pop_back();
      if (reached[e]) continue;
      triangles.push_back(corners_of(edges, e, clockwise));
      for (const Edge side : {e, edges.next(e), edges.previous(e)}) {
        reached[side] = true;
        if (!edges.is_fixed(side))
          inner.push_back(PlanarEdges::twin(side));
        else if ((clockwise ? preceding_ : following_)[edges.origin(side)] != edges.target(side))
          return std::nullopt;
      }
    }
    if (triangles.size() + 2 != count_) return std::nullopt;
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
  std::vector<Point> at_place_;               // of each vertex the one that stands for its place
  std::vector<Point> following_, preceding_;  // on the border; a vertex that is on none follows itself
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
