#include "triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>

namespace durero::io {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Number = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;  // of a vertex of the polygon
using Outside =
    CGAL::Triangulation_face_base_with_info_2<bool, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Number, Outside>,
                                               CGAL::No_constraint_intersection_tag>;

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
std::vector<Point> seen_along(int axis, std::span<const glm::dvec3> polygon) {
  std::vector<Point> points;
  points.reserve(polygon.size());
  for (const glm::dvec3& p : polygon) points.emplace_back(p[(axis + 1) % 3], p[(axis + 2) % 3]);
  return points;
}

/// Marks the faces that are reached from outside without a step over an edge of the polygon.
void mark_outside(Triangulation& triangulation) {
  for (const auto face : triangulation.all_face_handles()) face->info() = false;
  std::vector reached{triangulation.infinite_face()};
  reached.front()->info() = true;
  while (!reached.empty()) {
    const auto face = reached.back();
    reached.pop_back();
    for (int i = 0; i < 3; ++i) {
      const auto neighbor = face->neighbor(i);
      if (neighbor->info() || face->is_constrained(i)) continue;
      neighbor->info() = true;
      reached.push_back(neighbor);
    }
  }
}

/// The corners of a face, which go counter-clockwise, in the polygon's direction and the least of them first.
CornerNumbers corners_of(const Triangulation::Face_handle& face, bool clockwise) {
  CornerNumbers corners{};
  for (int i = 0; i < 3; ++i) corners[static_cast<std::size_t>(i)] = face->vertex(i)->info();
  if (clockwise) std::swap(corners[1], corners[2]);
  std::ranges::rotate(corners, std::ranges::min_element(corners));
  return corners;
}

/// Precondition: the polygon is simple.
std::vector<CornerNumbers> cut(const std::vector<Point>& polygon) {
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  for (const Point& point : polygon) {
    vertices.push_back(triangulation.insert(point));
    vertices.back()->info() = static_cast<std::uint32_t>(vertices.size() - 1);
  }
  for (std::size_t i = 0; i < vertices.size(); ++i)
    triangulation.insert_constraint(vertices[i], vertices[(i + 1) % vertices.size()]);
  mark_outside(triangulation);
  const bool clockwise = CGAL::orientation_2(polygon.begin(), polygon.end(), Kernel()) == CGAL::CLOCKWISE;
  std::vector<CornerNumbers> triangles;
  for (const auto face : triangulation.finite_face_handles())
    if (!face->info()) triangles.push_back(corners_of(face, clockwise));
  std::ranges::sort(triangles);
  return triangles;
}

}  // namespace

std::optional<std::vector<CornerNumbers>> triangulated(std::span<const glm::dvec3> polygon) {
  if (polygon.size() == 3) return std::vector{CornerNumbers{0, 1, 2}};
  for (const int axis : axes_faced(polygon)) {
    const std::vector<Point> points = seen_along(axis, polygon);
    if (CGAL::is_simple_2(points.begin(), points.end(), Kernel())) return cut(points);
  }
  return std::nullopt;
}

}  // namespace durero::io
