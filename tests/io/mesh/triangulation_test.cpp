#include "io/mesh/triangulation.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "durero/number/rational.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"
#include "support/sanitized.hpp"

using namespace durero;
using io::CornerNumbers;
using number::exact;
using number::Rational;
using Polygon = std::vector<glm::dvec3>;

namespace {

// Twice the area of a triangle as it is seen along an axis, positive where it goes counter-clockwise.
Rational area(int axis, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  return (exact(b[u]) - exact(a[u])) * (exact(c[v]) - exact(a[v])) -
         (exact(b[v]) - exact(a[v])) * (exact(c[u]) - exact(a[u]));
}

Rational area(int axis, const Polygon& polygon) {
  Rational sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) sum += area(axis, polygon[0], polygon[i], polygon[i + 1]);
  return sum;
}

// Whether, seen along this axis, the triangles cover a simple polygon once and nothing outside of it. Each edge of the
// polygon must be passed once, in its direction, and every other edge as often as it is passed back: then the triangles
// go around each point as often as the polygon does, once inside and never outside; and none goes around backwards.
bool covers_once(int axis, const Polygon& polygon, const std::vector<CornerNumbers>& triangles) {
  const Rational whole = area(axis, polygon);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> passed;
  const auto pass = [&](std::uint32_t from, std::uint32_t to) { ++passed[{from, to}], --passed[{to, from}]; };
  Rational sum = 0;
  for (const auto& [a, b, c] : triangles) {
    if (std::max({a, b, c}) >= polygon.size()) return false;
    const Rational part = area(axis, polygon[a], polygon[b], polygon[c]);
    if (sign(part) == 0 || sign(part) != sign(whole)) return false;
    sum += part;
    pass(a, b), pass(b, c), pass(c, a);
  }
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (std::uint32_t i = 0; i < n; ++i) pass((i + 1) % n, i);
  return triangles.size() == n - 2 && sum == whole &&
         std::ranges::all_of(passed, [](const auto& p) { return p.second == 0; });
}

bool covers_once_along_some_axis(const Polygon& polygon) {
  const auto triangles = io::triangulated(polygon);
  if (!triangles || !std::ranges::is_sorted(*triangles)) return false;
  return covers_once(0, polygon, *triangles) || covers_once(1, polygon, *triangles) ||
         covers_once(2, polygon, *triangles);
}

struct Cell {
  std::int64_t x, y;
  bool operator==(const Cell&) const = default;
};

std::int64_t side(Cell a, Cell b, Cell c) {
  const std::int64_t area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return (area > 0) - (area < 0);
}

bool lies_on(Cell w, Cell a, Cell b) {
  return side(a, b, w) == 0 && std::min(a.x, b.x) <= w.x && w.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= w.y &&
         w.y <= std::max(a.y, b.y);
}

bool meet(Cell a, Cell b, Cell c, Cell d) {
  return lies_on(a, c, d) || lies_on(b, c, d) || lies_on(c, a, b) || lies_on(d, a, b) ||
         (side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b) && side(a, b, c) * side(a, b, d) != 0 &&
          side(c, d, a) * side(c, d, b) != 0);
}

// Whether no two edges have a point in common but for neighbours, which have the vertex between them: by its
// definition.
bool is_simple(const std::vector<Cell>& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Cell a = p[i], b = p[(i + 1) % n], c = p[(i + 2) % n];
    if (a == b || lies_on(c, a, b) || lies_on(a, b, c)) return false;
    for (std::size_t j = i + 2; j < n && (j + 1) % n != i; ++j)
      if (meet(a, b, p[j], p[(j + 1) % n])) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("A polygon is cut into triangles in its direction, the least vertex first") {
  const Polygon l{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  CHECK(io::triangulated(l) == std::vector<CornerNumbers>{{0, 1, 3}, {0, 3, 5}, {1, 2, 3}, {3, 4, 5}});
  const Polygon around(l.rbegin(), l.rend());
  CHECK(covers_once_along_some_axis(l));
  CHECK(covers_once_along_some_axis(around));
  CHECK(io::triangulated(Polygon{{7, 7, 7}, {7, 7, 7}, {8, 8, 8}}) == std::vector<CornerNumbers>{{0, 1, 2}});
}

TEST_CASE("A polygon whose edges touch or cross is not cut") {
  const auto is_cut = [](const Polygon& polygon) { return io::triangulated(polygon).has_value(); };
  CHECK_FALSE(is_cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}));             // an hourglass
  CHECK_FALSE(is_cut({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}));             // a vertex twice
  CHECK_FALSE(is_cut({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}}));             // an edge back over the last
  CHECK_FALSE(is_cut({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 0, 0}, {0, 4, 0}}));  // a vertex on an edge
  CHECK_FALSE(is_cut({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}));             // on one line
}

TEST_CASE("Coordinates of any size are cut exactly") {
  CHECK(covers_once_along_some_axis({{-1e308, 0, -1e308}, {1e308, 0, 1e308}, {1e308, 1e308, 0}, {0, 1e308, 0}}));
  CHECK(covers_once_along_some_axis({{0, 0, 0}, {5e-324, 0, 0}, {5e-324, 5e-324, 0}, {0, 5e-324, 0}}));
  const double near = 1 + 0x1p-52;  // a quadrilateral as thin as doubles allow, by which its plane is known
  CHECK(covers_once_along_some_axis({{1, 1, 1}, {2, 2, 2}, {1.5, 1.5, 1.5 + 0x1p-52}, {near, near, near + 0x1p-52}}));
}

TEST_CASE("A comb of many teeth and a spiral") {
  Polygon comb{{0, -1, 0}};
  for (int i = 0; i <= 200; ++i) comb.push_back({i % 2 == 0 ? 0.0 : 50.0, i, 0.25 * i});
  CHECK(covers_once_along_some_axis(comb));
  Polygon spiral, back;
  for (int i = 0; i < 60; ++i) {
    const double r = 3 * i + 4, x = i % 4 < 2 ? r : -r, y = (i + 1) % 4 < 2 ? r : -r;
    spiral.push_back({0, x, y});
    back.push_back({0, x - (x > 0 ? 1 : -1), y - (y > 0 ? 1 : -1)});
  }
  spiral.insert(spiral.end(), back.rbegin(), back.rend());
  CHECK(covers_once_along_some_axis(spiral));
}

TEST_CASE("A polygon in a plane is cut if and only if it is simple") {
  std::size_t simple = 0, others = 0;
  test::property("points of a small grid, in any plane", [&] {
    const auto below = [](int end) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, end)); };
    const auto small = [&](int most) { return below(2 * most + 1) - most; };
    std::vector<Cell> cells(static_cast<std::size_t>(4 + below(5)));
    for (Cell& cell : cells) cell = {small(3), small(3)};
    const auto triple = [&] { return glm::dvec3{small(5), small(5), small(5)}; };
    const glm::dvec3 origin = triple(), across = triple(), up = triple();
    const bool flat =
        across.y * up.z == across.z * up.y && across.z * up.x == across.x * up.z && across.x * up.y == across.y * up.x;
    RC_PRE(!flat);
    Polygon polygon;
    for (const Cell& cell : cells)
      polygon.push_back(origin + static_cast<double>(cell.x) * across + static_cast<double>(cell.y) * up);
    RC_ASSERT(covers_once_along_some_axis(polygon) == is_simple(cells));
    RC_ASSERT(io::triangulated(polygon).has_value() == is_simple(cells));
    ++(is_simple(cells) ? simple : others);
  });
  if (!test::sanitized) CHECK((simple > 0 && others > 0));
}

TEST_CASE("A polygon that is not flat is cut all the same, along the axis that it faces") {
  // Seen along z the third vertex is a notch, seen along x, which it faces least, the second.
  const Polygon arrow{{0, 0, 0}, {4, 0.5, 0.02}, {1, 1, 0.1}, {0, 4, 0}};
  CHECK(io::triangulated(arrow) == std::vector<CornerNumbers>{{0, 1, 2}, {0, 2, 3}});
  test::property("heights over a convex outline", [] {
    Polygon polygon{{0, 0, 0}, {4, -1, 0}, {6, 2, 0}, {4, 5, 0}, {1, 4, 0}, {-1, 2, 0}};
    for (glm::dvec3& p : polygon) p.z = *rc::gen::inRange(-1000, 1001) * 0x1p-12;
    const auto triangles = io::triangulated(polygon);
    RC_ASSERT(triangles.has_value());
    RC_ASSERT(covers_once(2, polygon, *triangles));
  });
}
