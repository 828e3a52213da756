#include "io/mesh/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
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
  const auto place = [&](std::uint32_t corner) {  // the first vertex at its place
    return static_cast<std::uint32_t>(std::ranges::find(polygon, polygon[corner]) - polygon.begin());
  };
  const auto pass = [&](std::uint32_t from, std::uint32_t to) {
    ++passed[{place(from), place(to)}], --passed[{place(to), place(from)}];
  };
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

// The sign of the determinant of four lifted points: positive where d lies within the circle of a, b and c, which go
// counter-clockwise. Exact for small numbers.
std::int64_t circle_determinant(Cell a, Cell b, Cell c, Cell d) {
  const auto lifted = [&](Cell p) { return (p.x - d.x) * (p.x - d.x) + (p.y - d.y) * (p.y - d.y); };
  const auto minor = [&](Cell p, Cell q) { return (p.x - d.x) * (q.y - d.y) - (p.y - d.y) * (q.x - d.x); };
  return lifted(a) * minor(b, c) + lifted(b) * minor(c, a) + lifted(c) * minor(a, b);
}

// Whether of two triangles with an edge in common that is none of the polygon's neither has the other's corner within
// its circle, nor, where the four corners lie on one circle, is the last of them, by x and then by y, on that edge.
bool keeps_delaunay(const std::vector<Cell>& polygon, const std::vector<CornerNumbers>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> across;  // of each directed edge the third corner
  for (const auto& [a, b, c] : triangles) across[{a, b}] = c, across[{b, c}] = a, across[{c, a}] = b;
  return std::ranges::all_of(across, [&](const auto& triangle) {
    const auto [edge, c] = triangle;
    const auto [a, b] = edge;
    const auto other = across.find({b, a});
    if (other == across.end()) return true;
    const Cell p = polygon[a], q = polygon[b], r = polygon[c], s = polygon[other->second];
    const std::int64_t within = circle_determinant(p, q, r, s) * side(p, q, r);
    const auto place = [](Cell cell) { return std::pair(cell.x, cell.y); };
    return within < 0 || (within == 0 && std::max(place(p), place(q)) < std::max(place(r), place(s)));
  });
}

// The triangles by the places of their corners, in no order.
std::set<std::set<std::pair<std::int64_t, std::int64_t>>> places_of(const std::vector<Cell>& polygon,
                                                                    const std::vector<CornerNumbers>& triangles) {
  std::set<std::set<std::pair<std::int64_t, std::int64_t>>> places;
  for (const CornerNumbers& corners : triangles) {
    std::set<std::pair<std::int64_t, std::int64_t>> triangle;
    for (const std::uint32_t corner : corners) triangle.insert({polygon[corner].x, polygon[corner].y});
    places.insert(triangle);
  }
  return places;
}

Polygon on_floor(const std::vector<Cell>& cells) {
  Polygon polygon;
  for (const Cell& cell : cells) polygon.emplace_back(cell.x, cell.y, 0);
  return polygon;
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

// Whether it goes along some edge there and back.
bool has_seam(const std::vector<Cell>& p) {
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < p.size(); ++j)
      if (p[i] == p[(j + 1) % p.size()] && p[j] == p[(i + 1) % p.size()]) return true;
  return false;
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
  CHECK_FALSE(is_cut({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}));             // on one point
  CHECK_FALSE(is_cut({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {2, 5, 0}, {2, 2, 0}, {0, 2, 0}}));  // a spike
  const Polygon square{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}};
  Polygon touched = square;  // a notch up to the edge across
  for (const glm::dvec3& p : Polygon{{0, 6, 0}, {9, 5, 0}, {0, 4, 0}}) touched.push_back(p);
  CHECK_FALSE(is_cut(touched));
  // The edge from the first vertex goes between two others before it meets one.
  CHECK_FALSE(is_cut(on_floor({{0, 0}, {6, 0}, {6, -5}, {4, 0}, {2, -1}, {2, -5}, {-3, -5}, {-3, 4}, {2, 1}})));
}

TEST_CASE("A polygon with holes is cut where it comes to them by seams, and they go round the other way") {
  const Polygon square{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0}};
  const auto with = [&](const Polygon& more) {
    Polygon all = square;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const Polygon hole{{3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}, {3, 3, 0}}, around(hole.rbegin(), hole.rend());
  CHECK(covers_once_along_some_axis(with(hole)));
  CHECK(covers_once_along_some_axis(
      {hole[0], hole[1], hole[2], hole[3], {3, 3, 0}, {0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0}}));
  Polygon two = with({{1, 1, 0}, {1, 2, 0}, {2, 1, 0}, {1, 1, 0}, {0, 0, 0}});
  two.insert(two.end(), hole.begin(), hole.end());
  CHECK(covers_once_along_some_axis(two));
  CHECK_FALSE(io::triangulated(with(around)));  // it goes round as the square
  CHECK_FALSE(io::triangulated(with({{-3, -3, 0}, {-6, -3, 0}, {-3, -6, 0}, {-3, -3, 0}})));  // it is outside
  CHECK_FALSE(io::triangulated(with({{9, 3, 0}, {3, 6, 0}, {6, 6, 0}, {9, 3, 0}})));          // it touches an edge
}

TEST_CASE("Vertices between others on a line are corners of triangles too") {
  Polygon dense;
  for (int i = 0; i < 4; ++i) dense.emplace_back(i, 0, 0);
  for (int i = 0; i < 4; ++i) dense.emplace_back(4, i, 0);
  for (int i = 0; i < 4; ++i) dense.emplace_back(4 - i, 4, 0);
  for (int i = 0; i < 4; ++i) dense.emplace_back(0, 4 - i, 0);
  CHECK(covers_once_along_some_axis(dense));
  const Polygon triangle{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 3, 0}};
  CHECK(io::triangulated(triangle) == std::vector<CornerNumbers>{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}});
}

TEST_CASE("On one circle the last vertex, by x and then by y, is cut off") {
  const Polygon square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  CHECK(io::triangulated(square) == std::vector<CornerNumbers>{{0, 1, 3}, {1, 2, 3}});
  const std::vector<Cell> circle{{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-3, 4}, {-4, -3}, {0, -5}, {3, -4}};
  const auto triangles = io::triangulated(on_floor(circle));
  REQUIRE(triangles.has_value());
  CHECK(keeps_delaunay(circle, *triangles));
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
    const bool is_cut = io::triangulated(polygon).has_value();
    RC_ASSERT(covers_once_along_some_axis(polygon) == is_cut);
    RC_ASSERT(is_cut == is_simple(cells) || (is_cut && has_seam(cells)));
    if (const auto triangles = io::triangulated(on_floor(cells))) RC_ASSERT(keeps_delaunay(cells, *triangles));
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

TEST_CASE("A polygon of many vertices has the triangles of Delaunay, wherever it begins and whichever way it goes") {
  test::property("vertices put between two others while the polygon stays simple", [] {
    const auto below = [](int end) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, end)); };
    std::vector<Cell> cells{{0, 0}, {12, 0}, {0, 12}};
    for (int tries = 4 + below(40); tries-- > 0;) {
      std::vector<Cell> more = cells;
      const Cell cell{below(13), below(13)};
      more.insert(more.begin() + below(static_cast<int>(cells.size())) + 1, cell);
      if (is_simple(more)) cells = more;
    }
    RC_PRE(cells.size() > 3);
    const auto triangles = io::triangulated(on_floor(cells));
    RC_ASSERT(triangles.has_value());
    RC_ASSERT(covers_once(2, on_floor(cells), *triangles));
    RC_ASSERT(keeps_delaunay(cells, *triangles));
    std::vector<Cell> others = cells;
    std::ranges::rotate(others, others.begin() + below(static_cast<int>(cells.size())));
    if (below(2) == 0) std::ranges::reverse(others);
    const auto again = io::triangulated(on_floor(others));
    RC_ASSERT(again.has_value());
    RC_ASSERT(places_of(others, *again) == places_of(cells, *triangles));
  });
}

TEST_CASE("Combs, circles, stars and spirals of n vertices take some n log n decisions") {
  const auto comb = [](int n) {
    Polygon polygon{{-1, -1, 0}};
    for (int i = 0; i + 1 < n; ++i) polygon.emplace_back(i, i % 2 == 0 ? 0 : n, 0);
    return polygon;
  };
  const auto flat_comb = [](int n) {
    Polygon polygon;
    for (int i = 0; i < n / 2; ++i) polygon.emplace_back(i, i % 2, 0);
    for (int i = n / 2; i-- > 0;) polygon.emplace_back(i, i % 2 == 0 ? 1.5 : 2, 0);
    return polygon;
  };
  const auto circle = [](int n) {
    Polygon polygon;
    for (int i = 0; i < n; ++i) polygon.emplace_back(std::cos(i * 6.28 / n), std::sin(i * 6.28 / n), 0);
    return polygon;
  };
  const auto star = [](int n) {
    Polygon polygon;
    for (int i = 0; i < n; ++i) {
      const double r = 1 + i * 37 % 101 / 101.0, angle = i * 6.28 / n;
      polygon.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
    return polygon;
  };
  const auto spiral = [](int n) {
    Polygon polygon, back;
    for (int i = 0; i < n / 2; ++i) {
      const double r = 3 * i + 4, x = i % 4 < 2 ? r : -r, y = (i + 1) % 4 < 2 ? r : -r;
      polygon.emplace_back(x, y, 0);
      back.emplace_back(x - (x > 0 ? 1 : -1), y - (y > 0 ? 1 : -1), 0);
    }
    polygon.insert(polygon.end(), back.rbegin(), back.rend());
    return polygon;
  };
  const std::vector<std::function<Polygon(int)>> families{comb, flat_comb, circle, star, spiral};
  for (std::size_t family = 0; family < families.size(); ++family) {
    for (const int n : {100, 1000, test::sanitized ? 2000 : 10000}) {
      INFO("family " << family << ", " << n << " vertices");
      std::uint64_t decisions = 0;
      const auto triangles = io::triangulated(families[family](n), &decisions);
      REQUIRE(triangles.has_value());
      CHECK(triangles->size() == static_cast<std::size_t>(n) - 2);
      CHECK(static_cast<double>(decisions) < 10 * n * std::log2(n));
    }
  }
}
