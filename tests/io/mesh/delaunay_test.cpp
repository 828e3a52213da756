#include "io/mesh/delaunay.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "io/mesh/constraints.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;
using Plane = std::vector<glm::dvec2>;

namespace {

using io::PlanarEdges;
using io::PlanePoints;

std::vector<PlanePoints::Number> by_place(const PlanePoints& points) {
  std::vector<PlanePoints::Number> numbers(points.size());
  std::iota(numbers.begin(), numbers.end(), PlanePoints::Number{0});
  std::ranges::sort(numbers, [&](auto a, auto b) { return points.is_before(a, b); });
  return numbers;
}

PlanarEdges edges_of(const PlanePoints& points) { return io::delaunay_edges(points, by_place(points)); }

// The edges that can be reached, by the points between which they are.
using Ends = std::pair<std::pair<double, double>, std::pair<double, double>>;
std::set<Ends> ends_of(const PlanarEdges& edges, const Plane& plane) {
  std::set<Ends> ends;
  for (PlanePoints::Number p = 0; p < plane.size(); ++p) {
    PlanarEdges::Edge e = edges.leaving(p);
    do {
      const glm::dvec2 from = plane[p], to = plane[edges.target(e)];
      ends.insert({{from.x, from.y}, {to.x, to.y}});
      e = edges.after(e);
    } while (e != edges.leaving(p));
  }
  return ends;
}

// Whether the face to the left of an edge is a triangle.
bool is_triangle(const PlanarEdges& edges, const PlanePoints& points, PlanarEdges::Edge e) {
  return edges.next(edges.next(edges.next(e))) == e && points.turn(edges.origin(e), edges.target(e), edges.apex(e)) > 0;
}

// Whether no point lies within the circle of a triangle: of all points, or locally of those across its edges that are
// not fixed.
bool is_delaunay(const PlanarEdges& edges, const PlanePoints& points, bool locally) {
  for (PlanePoints::Number p = 0; p < points.size(); ++p) {
    PlanarEdges::Edge e = edges.leaving(p);
    do {
      if (is_triangle(edges, points, e)) {
        const auto is_within = [&](PlanePoints::Number d) {
          return d != p && d != edges.target(e) && d != edges.apex(e) &&
                 points.is_within_circle(p, edges.target(e), edges.apex(e), d);
        };
        if (locally && !edges.is_fixed(e) && is_within(edges.apex(PlanarEdges::twin(e)))) return false;
        for (PlanePoints::Number d = 0; !locally && d < points.size(); ++d)
          if (is_within(d)) return false;
      }
      e = edges.after(e);
    } while (e != edges.leaving(p));
  }
  return true;
}

std::size_t triangles_of(const PlanarEdges& edges, const PlanePoints& points) {
  std::size_t sides = 0;
  for (PlanePoints::Number p = 0; p < points.size(); ++p) {
    PlanarEdges::Edge e = edges.leaving(p);
    do {
      sides += is_triangle(edges, points, e) ? 1 : 0;
      e = edges.after(e);
    } while (e != edges.leaving(p));
  }
  return sides / 3;
}

std::size_t corners_of_hull(const PlanarEdges& edges, const PlanePoints& points) {
  std::size_t corners = 0;
  for (PlanePoints::Number p = 0; p < points.size(); ++p) {
    PlanarEdges::Edge e = edges.leaving(p);
    do {
      corners += edges.is_fixed(e) ? 1 : 0;
      e = edges.after(e);
    } while (e != edges.leaving(p));
  }
  return corners / 2;
}

Plane distinct_points(int least, int most, int side) {
  const auto below = [](int end) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, end)); };
  std::set<std::pair<int, int>> places;
  for (int count = least + below(most - least + 1); count-- > 0;) {
    const int u = below(side), v = below(side);
    places.insert({u, v});
  }
  Plane plane;
  for (const auto& [u, v] : places) plane.emplace_back(u, v);
  return plane;
}

Plane shuffled(Plane plane) {
  for (std::size_t i = plane.size(); i > 1; --i)
    std::swap(plane[i - 1], plane[*rc::gen::resize(rc::kNominalSize, rc::gen::inRange(std::size_t{0}, i))]);
  return plane;
}

}  // namespace

TEST_CASE("The last point of a circle is outside the circle of the others") {
  const PlanePoints square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  CHECK_FALSE(square.is_within_circle(0, 1, 3, 2));  // (1, 1) is the last
  CHECK_FALSE(square.is_within_circle(1, 3, 0, 2));
  CHECK(square.is_within_circle(0, 1, 2, 3));
  CHECK(square.is_within_circle(2, 3, 0, 1));
  CHECK_FALSE(square.is_within_circle(1, 2, 3, 0));
  CHECK(ends_of(edges_of(square), {{0, 0}, {1, 0}, {1, 1}, {0, 1}}).contains({{1, 0}, {0, 1}}));
}

TEST_CASE("Points on one line have the edges between neighbours") {
  for (const std::size_t count : {2U, 3U, 4U, 5U, 9U}) {
    Plane plane;
    for (std::size_t i = 0; i < count; ++i) plane.emplace_back(0.25 * static_cast<double>(i), static_cast<double>(i));
    CHECK(ends_of(edges_of(PlanePoints(plane)), plane).size() == 2 * (count - 1));
  }
}

TEST_CASE("No point lies within the circle of a triangle, and the order of the points changes nothing") {
  test::property("points of a small grid, of which many share circles and lines", [] {
    const Plane plane = distinct_points(3, 24, 6);
    RC_PRE(plane.size() > 2);
    const PlanePoints points(plane);
    const PlanarEdges edges = edges_of(points);
    RC_ASSERT(is_delaunay(edges, points, false));
    const std::size_t hull = corners_of_hull(edges, points);
    const std::size_t triangles = triangles_of(edges, points);
    // By Euler's formula, where not all are on one line.
    if (triangles > 0) RC_ASSERT(triangles == 2 * plane.size() - 2 - hull);
    const Plane others = shuffled(plane);
    RC_ASSERT(ends_of(edges_of(PlanePoints(others)), others) == ends_of(edges, plane));
  });
}

TEST_CASE("A constraint is an edge of the triangulation, or is refused where a point or another is in its way") {
  const Plane plane{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}, {1, 2}};
  const PlanePoints points(plane);
  PlanarEdges edges = edges_of(points);
  CHECK_FALSE(io::constrain(edges, points, 0, 2));  // through (2, 2)
  CHECK_FALSE(io::constrain(edges, points, 2, 0));
  CHECK(io::constrain(edges, points, 1, 5));
  CHECK(io::constrain(edges, points, 5, 1));        // once more
  CHECK_FALSE(io::constrain(edges, points, 0, 4));  // over the one before
  CHECK(ends_of(edges, plane).contains({{4, 0}, {1, 2}}));
}

TEST_CASE("The triangles between constraints are those of Delaunay, and the order of the constraints changes nothing") {
  std::size_t put = 0, refused = 0;
  test::property("chords between points of a grid", [&] {
    const auto below = [](std::size_t end) {
      return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(std::size_t{0}, end));
    };
    const Plane plane = distinct_points(8, 40, 9);
    RC_PRE(plane.size() > 3);
    const PlanePoints points(plane);
    PlanarEdges edges = edges_of(points);
    const std::size_t triangles = triangles_of(edges, points);
    std::vector<std::pair<PlanePoints::Number, PlanePoints::Number>> kept;
    for (int tries = 8; tries-- > 0;) {
      const auto from = static_cast<PlanePoints::Number>(below(plane.size()));
      const auto to = static_cast<PlanePoints::Number>(below(plane.size()));
      if (from == to) continue;
      const std::set<Ends> before = ends_of(edges, plane);
      const bool is_put = io::constrain(edges, points, from, to);
      ++(is_put ? put : refused);
      if (is_put) kept.emplace_back(from, to);
      if (!is_put) RC_ASSERT(ends_of(edges, plane) == before);
      RC_ASSERT(!is_put ||
                ends_of(edges, plane).contains({{plane[from].x, plane[from].y}, {plane[to].x, plane[to].y}}));
    }
    RC_ASSERT(triangles_of(edges, points) == triangles);
    RC_ASSERT(is_delaunay(edges, points, true));
    PlanarEdges again = edges_of(points);
    for (auto constraint = kept.rbegin(); constraint != kept.rend(); ++constraint)
      RC_ASSERT(io::constrain(again, points, constraint->second, constraint->first));
    RC_ASSERT(ends_of(again, plane) == ends_of(edges, plane));
  });
  if (!test::sanitized) CHECK((put > 0 && refused > 0));
}
