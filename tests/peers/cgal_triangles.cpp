// cgal_triangles [POLYGONS]: random polygons, and random rings within each other, through the triangulation of the mesh
// readers and through CGAL's constrained Delaunay triangulation, which share no line. Each polygon must be cut by both,
// into the same triangles, or by neither; but one that comes to holes by seams is cut by the readers alone, into
// triangles of its area. Of the rings each edge must be the other's. Many vertices share lines and circles. Exit status
// 1 where the two differ; 77 (skipped) where CGAL is absent (Debian: libcgal-dev).
#include <iostream>

#if __has_include(<CGAL/Constrained_Delaunay_triangulation_2.h>)
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

#include "io/mesh/constraints.hpp"
#include "io/mesh/delaunay.hpp"
#include "io/mesh/triangulation.hpp"

using namespace durero;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Cells = CGAL::Triangulation_data_structure_2<Vertex, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Cells, CGAL::No_constraint_intersection_tag>;
using Ring = std::vector<glm::dvec2>;
using Numbers = std::set<std::set<std::uint32_t>>;

/// CGAL's triangulation of all vertices of the rings, whose edges are constraints.
Triangulation by_cgal(const std::vector<Ring>& rings) {
  Triangulation made;
  std::uint32_t count = 0;
  std::vector<std::vector<Triangulation::Vertex_handle>> handles;
  for (const Ring& ring : rings) {
    handles.emplace_back();
    for (const glm::dvec2& p : ring) {
      handles.back().push_back(made.insert({p.x, p.y}));
      handles.back().back()->info() = count++;
    }
  }
  for (const auto& of_ring : handles)
    for (std::size_t i = 0; i < of_ring.size(); ++i)
      made.insert_constraint(of_ring[i], of_ring[(i + 1) % of_ring.size()]);
  return made;
}

bool is_simple_by_cgal(const Ring& ring) {
  std::vector<Kernel::Point_2> points;
  for (const glm::dvec2& p : ring) points.emplace_back(p.x, p.y);
  return CGAL::is_simple_2(points.begin(), points.end(), Kernel());
}

/// The triangles within a simple polygon: by their corners, in whichever direction.
Numbers triangles_by_cgal(const Ring& ring) {
  const Triangulation made = by_cgal({ring});
  std::set<Triangulation::Face_handle> outside{made.infinite_face()};
  std::vector<Triangulation::Face_handle> reached{made.infinite_face()};
  while (!reached.empty()) {
    const auto face = reached.back();
    reached.pop_back();
    for (int i = 0; i < 3; ++i)
      if (!face->is_constrained(i) && outside.insert(face->neighbor(i)).second) reached.push_back(face->neighbor(i));
  }
  Numbers triangles;
  for (const auto face : made.finite_face_handles())
    if (!outside.contains(face))
      triangles.insert({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return triangles;
}

/// Whether an edge is passed in both directions, as a seam is that leads to a hole.
bool has_seam(const Ring& ring) {
  const auto edge = [&](std::size_t i) { return std::pair(ring[i], ring[(i + 1) % ring.size()]); };
  for (std::size_t i = 0; i < ring.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (edge(i).first == edge(j).second && edge(i).second == edge(j).first) return true;
  return false;
}

/// Twice the area that a ring goes around to the left; exact on a small grid.
double doubled_area(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const glm::dvec2 &p = ring[i], &q = ring[(i + 1) % ring.size()];
    sum += p.x * q.y - p.y * q.x;
  }
  return sum;
}

/// Whether a polygon that comes to its holes by seams, which CGAL does not call simple, has the area of its triangles.
bool is_cut_by_seams(const Ring& ring, const std::vector<io::CornerNumbers>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) sum += std::abs(doubled_area({ring[a], ring[b], ring[c]}));
  return has_seam(ring) && sum == std::abs(doubled_area(ring));
}

bool are_cut_alike(const Ring& ring) {
  std::vector<glm::dvec3> polygon;
  for (const glm::dvec2& p : ring) polygon.emplace_back(p, 0);
  const auto triangles = io::triangulated(polygon);
  const bool is_simple = is_simple_by_cgal(ring);
  if (!triangles) return !is_simple;
  if (!is_simple) return is_cut_by_seams(ring, *triangles);
  Numbers numbers;
  for (const io::CornerNumbers& corners : *triangles) numbers.insert({corners.begin(), corners.end()});
  return numbers == triangles_by_cgal(ring);
}

Numbers edges_by_cgal(const std::vector<Ring>& rings) {
  const Triangulation made = by_cgal(rings);
  Numbers edges;
  for (const auto& [face, i] : made.finite_edges())
    edges.insert({face->vertex(made.cw(i))->info(), face->vertex(made.ccw(i))->info()});
  return edges;
}

/// Nothing where a constraint is refused.
Numbers edges_by_durero(const std::vector<Ring>& rings) {
  Ring all;
  for (const Ring& ring : rings) all.insert(all.end(), ring.begin(), ring.end());
  const io::PlanePoints points(all);
  std::vector<std::uint32_t> by_place(all.size());
  std::iota(by_place.begin(), by_place.end(), 0U);
  std::ranges::sort(by_place, [&](auto a, auto b) { return points.is_before(a, b); });
  io::PlanarEdges made = io::delaunay_edges(points, by_place);
  std::uint32_t first = 0;
  for (const Ring& ring : rings) {
    const auto count = static_cast<std::uint32_t>(ring.size());
    for (std::uint32_t i = 0; i < count; ++i)
      if (!io::constrain(made, points, first + i, first + (i + 1) % count)) return {};
    first += count;
  }
  Numbers edges;
  for (std::uint32_t p = 0; p < all.size(); ++p) {
    io::PlanarEdges::Edge e = made.leaving(p);
    do {
      edges.insert({p, made.target(e)});
      e = made.after(e);
    } while (e != made.leaving(p));
  }
  return edges;
}

/// Draws polygons of several kinds.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}

  int integer(int least, int most) { return std::uniform_int_distribution(least, most)(engine_); }

  /// Any vertices on a small grid: few such polygons are simple.
  Ring on_grid() {
    Ring ring(static_cast<std::size_t>(integer(4, 8)));
    const int side = integer(1, 4);
    for (glm::dvec2& p : ring) p.x = integer(0, side), p.y = integer(0, side);
    return ring;
  }

  /// A tour of vertices on a grid that is shortened until no two edges cross: most such polygons are simple.
  Ring tour() {
    Ring ring(static_cast<std::size_t>(integer(4, 40)));
    const int side = integer(6, 60);
    for (glm::dvec2& p : ring) p.x = integer(0, side), p.y = integer(0, side);
    while (shorten(ring)) {
    }
    return ring;
  }

  /// Around the middle, on one circle or between two.
  Ring star(double least, double most, int count) {
    Ring ring;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      const double radius = least + (most - least) * integer(0, 1000) / 1000;
      ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    if (integer(0, 1) == 0) std::ranges::reverse(ring);
    std::ranges::rotate(ring, ring.begin() + integer(0, count - 1));
    return ring;
  }

  /// Columns side by side, with right angles.
  Ring columns() {
    Ring ring{{0, 0}};
    const int count = integer(2, 20);
    for (int i = 0, height = 0; i < count; ++i) {
      height = 1 + (height + integer(0, 2)) % 4;  // another than the last
      ring.emplace_back(i, height);
      ring.emplace_back(i + 1, height);
    }
    ring.emplace_back(count, 0);
    return ring;
  }

  /// Points with whole coordinates, drawn from those of one circle, in their order.
  Ring circle(int scale) {
    Ring ring;
    for (int x = -65; x <= 65; ++x)
      for (int y = -65; y <= 65; ++y)
        if (x * x + y * y == 65 * 65 && integer(0, 3) != 0) ring.emplace_back(scale * x, scale * y);
    std::ranges::sort(ring, {}, [](const glm::dvec2& p) { return std::atan2(p.y, p.x); });
    return ring;
  }

  /// A polygon around others, which are holes in it, and what lies in the holes.
  std::vector<Ring> rings() {
    std::vector<Ring> rings;
    for (int scale = integer(0, 1) == 0 ? 64 : 16; scale > 0; scale /= 4) {
      const int count = integer(10, 40);
      rings.push_back(integer(0, 1) == 0 ? circle(scale) : star(50 * scale, 65 * scale, count));
    }
    return rings;
  }

 private:
  static bool shorten(Ring& ring) {
    const auto length = [](const glm::dvec2& a, const glm::dvec2& b) { return std::hypot(a.x - b.x, a.y - b.y); };
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i + 2 < n; ++i) {
      for (std::size_t j = i + 2; j < n && (j + 1) % n != i; ++j) {
        const glm::dvec2 a = ring[i], b = ring[i + 1], c = ring[j], d = ring[(j + 1) % n];
        if (length(a, c) + length(b, d) > length(a, b) + length(c, d) - 1e-6) continue;
        std::reverse(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     ring.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        return true;
      }
    }
    return false;
  }

  std::mt19937_64 engine_;
};

}  // namespace

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 100'000;
  Draw draw(1);
  std::size_t cut = 0, differ = 0, unlike_rings = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_circle = draw.integer(0, 1) == 0;
    const Ring ring = i % 4 == 0   ? draw.on_grid()
                      : i % 4 == 1 ? draw.tour()
                      : i % 4 == 2 ? draw.star(is_circle ? 1 : 0.25, 1, draw.integer(4, 60))
                                   : draw.columns();
    cut += is_simple_by_cgal(ring);
    differ += !are_cut_alike(ring);
    if (i % 10 != 0) continue;
    const std::vector<Ring> rings = draw.rings();
    unlike_rings += edges_by_cgal(rings) != edges_by_durero(rings);
  }
  std::cout << count << " polygons, " << cut << " of them simple: " << differ << " are cut otherwise by CGAL; "
            << (count + 9) / 10 << " polygons with holes: " << unlike_rings << " have other edges\n";
  return differ + unlike_rings == 0 ? 0 : 1;
}

#else

int main() {
  std::cout << "skipped: CGAL is absent (Debian: libcgal-dev)\n";
  return 77;
}

#endif
