#include "durero/accel/touch.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "durero/surface/surfaces.hpp"

namespace durero::accel {
namespace {

using surface::Box;

// The slack, 2⁻⁴⁰ of the size that a number is compared with, exceeds the error of the number, which is made by less
// than 2⁸ roundings of sums of terms no greater than that size, from axes of unit length within 2⁻⁵⁰.
constexpr double slack = 0x1p-40;

double extent(const glm::dvec3& x) { return std::abs(x.x) + std::abs(x.y) + std::abs(x.z); }

/// A box relative to a point: every difference is rounded once, however far both lie from the origin of space.
struct RelativeBox {
  RelativeBox(const Box& box, const glm::dvec3& from)
      : low(box.low - from), high(box.high - from), middle(0.5 * low + 0.5 * high), half(0.5 * high - 0.5 * low) {
    size = std::max(extent(low), extent(high));
  }
  /// The least and the greatest w·c of its points w.
  double least(const glm::dvec3& c) const { return dot(middle, c) - dot(half, abs(c)); }
  double greatest(const glm::dvec3& c) const { return dot(middle, c) + dot(half, abs(c)); }

  glm::dvec3 low, high, middle, half;
  double size;
};

bool overlap(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

// The surface touches the box where the nearest point of the box is within the sphere and the farthest is not.
bool touched(const scene::Sphere& sphere, const Box& box) {
  const RelativeBox seen(box, sphere.centro);
  double nearest = 0, farthest = 0;
  for (int i = 0; i < 3; ++i) {
    const double near = std::max({seen.low[i], -seen.high[i], 0.0});
    const double far = std::max(-seen.low[i], seen.high[i]);
    nearest += near * near;
    farthest += far * far;
  }
  const double square = sphere.radio * sphere.radio;
  return nearest * (1 - slack) <= square && farthest * (1 + slack) >= square;
}

// Two convex bodies with flat faces are apart exactly where a plane along a face of one, or along an edge of each,
// separates them. The box's own faces have been tried.
bool touched(const scene::Triangle& triangle, const Box& box) {
  const RelativeBox seen(box, triangle.vertices[0]);
  const glm::dvec3 b = triangle.vertices[1] - triangle.vertices[0], c = triangle.vertices[2] - triangle.vertices[0];
  const double size = seen.size + extent(b) + extent(c);
  const auto parts = [&](const glm::dvec3& across, double scale) {
    const double of_b = dot(across, b), of_c = dot(across, c), less = slack * scale * size;
    return seen.least(across) > std::max({of_b, of_c, 0.0}) + less ||
           seen.greatest(across) < std::min({of_b, of_c, 0.0}) - less;
  };
  const double edges = extent(b) + extent(c);
  if (parts(cross(b, c), edges * edges)) return false;
  for (const glm::dvec3& edge : {b, c, c - b}) {
    if (parts({0, edge.z, -edge.y}, edges) || parts({-edge.z, 0, edge.x}, edges) || parts({edge.y, -edge.x, 0}, edges))
      return false;
  }
  return true;
}

/// The solid between two discs across a unit axis, which bounds a shape along the axis, with the radii of its ends.
struct AxialSolid {
  glm::dvec3 centro, vector;
  double altura, base, top;
};

// The test of a plane across c. Between the discs, w·c is at most that of the farther rim's farthest point: |c|² less
// (c·vector)² is the square of the part of c across the axis.
bool parted(const AxialSolid& solid, const RelativeBox& seen, const glm::dvec3& c) {
  const double along = dot(c, solid.vector);
  const double across = std::sqrt(std::max(0.0, dot(c, c) - along * along)) + slack * extent(c);
  const double farthest = std::max(solid.base * across, solid.altura * along + solid.top * across);
  const double size = seen.size + solid.altura + solid.base + solid.top;
  return seen.least(c) > farthest + slack * extent(c) * size;
}

/// Whether some plane separates the box from the solid: across the axis; along the axis and an edge of the box; or
/// tangent to the solid where it faces the middle of the box.
bool apart(const AxialSolid& solid, const RelativeBox& seen) {
  const glm::dvec3& d = solid.vector;
  const auto parted_either_way = [&](const glm::dvec3& c) { return parted(solid, seen, c) || parted(solid, seen, -c); };
  if (parted_either_way(d)) return true;
  for (const glm::dvec3& c : {glm::dvec3(0, d.z, -d.y), glm::dvec3(-d.z, 0, d.x), glm::dvec3(d.y, -d.x, 0)}) {
    if (parted_either_way(c)) return true;
  }
  const double advance = std::clamp(dot(seen.middle, d), 0.0, solid.altura);
  const glm::dvec3 from_axis = seen.middle - advance * d, nearest = clamp(advance * d, seen.low, seen.high);
  const glm::dvec3 out = seen.middle - dot(seen.middle, d) * d;
  const double length = std::sqrt(dot(out, out));
  if (parted(solid, seen, from_axis) || parted(solid, seen, nearest - advance * d)) return true;
  return length > 0 && solid.altura > 0 &&
         parted(solid, seen, out / length + (solid.base - solid.top) / solid.altura * d);
}

/// Whether every corner of the box, and so all of it, lies strictly inside the wall, extended beyond both ends.
bool within_wall(const AxialSolid& solid, const RelativeBox& seen) {
  const double slope = (solid.base - solid.top) / solid.altura;
  const double size = (seen.size + solid.altura + solid.base + solid.top) * (1 + slope);
  for (unsigned corner = 0; corner < 8; ++corner) {
    const glm::dvec3 w((corner & 1) != 0 ? seen.high.x : seen.low.x, (corner & 2) != 0 ? seen.high.y : seen.low.y,
                       (corner & 4) != 0 ? seen.high.z : seen.low.z);
    const double advance = dot(w, solid.vector), radius = solid.base - slope * advance;
    const glm::dvec3 out = w - advance * solid.vector;
    if (!(std::sqrt(dot(out, out)) < radius - slack * size)) return false;
  }
  return true;
}

bool touched(const scene::Disc& disc, const Box& box) {
  return !apart({disc.centro, disc.vector, 0, disc.radio, disc.radio}, RelativeBox(box, disc.centro));
}

bool touched(const AxialSolid& solid, const Box& box) {
  const RelativeBox seen(box, solid.centro);
  return !apart(solid, seen) && !within_wall(solid, seen);
}
bool touched(const scene::Cylinder& e, const Box& box) {
  return touched(AxialSolid{e.centro, e.vector, e.altura, e.radio, e.radio}, box);
}
bool touched(const scene::Cone& e, const Box& box) {
  return touched(AxialSolid{e.centro, e.vector, e.altura, e.proporcion * e.altura, 0}, box);
}
bool touched(const scene::TruncatedCone& e, const Box& box) {
  return touched(AxialSolid{e.centro, e.vector, e.altura, surface::radius_of_base(e), e.radio}, box);
}
// A plane has no finite box, so no structure asks for its cells.
bool touched(const scene::Plane& plane, const Box& box) {
  const RelativeBox seen(box, plane.centro);
  const double less = slack * seen.size * extent(plane.vector);
  return seen.least(plane.vector) <= less && seen.greatest(plane.vector) >= -less;
}

}  // namespace

bool touches(scene::ShapeView element, const Box& box) {
  return element.visit([&](const auto& shape) { return overlap(surface::box(shape), box) && touched(shape, box); });
}

}  // namespace durero::accel
