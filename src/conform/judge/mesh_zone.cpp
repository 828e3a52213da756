#include <algorithm>
#include <array>
#include <map>

#include "conform/judge/shell.hpp"
#include "conform/judge/zones.hpp"
#include "durero/surface/exact_element.hpp"

namespace durero::conform {
namespace {

using number::sign;
using scene::Triangles;
using surface::exact::Parameter;

/// Whether the triangles are a closed mesh: every edge belongs to an even number of them.
bool is_closed(const Triangles& triangles) {
  using Vertex = std::array<double, 3>;
  std::map<std::array<Vertex, 2>, int> times;
  for (const scene::Triangle triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 &a = triangle.vertices[i], &b = triangle.vertices[(i + 1) % 3];
      std::array<Vertex, 2> edge{Vertex{a.x, a.y, a.z}, Vertex{b.x, b.y, b.z}};
      std::sort(edge.begin(), edge.end());
      ++times[edge];
    }
  }
  return std::all_of(times.begin(), times.end(), [](const auto& edge) { return edge.second % 2 == 0; });
}

/// Whether the ray crosses an odd number of the triangles; nothing where it meets an edge or lies in the plane of a
/// triangle.
std::optional<bool> crosses_odd_number(const Triangles& triangles, const model::Rayo& rayo) {
  bool is_odd = false;
  for (const scene::Triangle triangle : triangles) {
    const surface::exact::Coefficients f = surface::exact::coefficients(triangle, rayo);
    if (sign(f.B) == 0 && sign(f.C) == 0) return std::nullopt;
    if (sign(f.B) * sign(f.C) >= 0) continue;  // no root is ahead
    int lowest = 1;
    for (const auto& bound : f.bounds) lowest = std::min(lowest, sign(bound.C));
    if (lowest == 0) return std::nullopt;
    is_odd = is_odd != (lowest > 0);
  }
  return is_odd;
}

/// Whether p lies strictly inside the closed mesh, by the parity of crossings of a ray from p. The fixed directions lie
/// along no edge of a mesh but by design; where each of them meets an edge, the answer is no.
bool is_inside(const Triangles& triangles, const model::Punto& p) {
  static constexpr std::array<glm::dvec3, 4> directions{
      {{1009, -709, 307}, {-419, 877, 1103}, {641, 211, -1301}, {-953, -547, 773}}};
  for (const glm::dvec3& direction : directions) {
    if (const auto is_odd = crosses_odd_number(triangles, {p, model::Vector(direction)})) return *is_odd;
  }
  return false;
}

/// The parameter at which the ray leaves the box of the triangles, grown by `grown` on every side. Precondition: the
/// ray starts in that box.
Parameter leaving(const Triangles& triangles, const model::Rayo& rayo, const Dyadic& grown) {
  const glm::dvec3 &p = rayo.p().xyz(), &v = rayo.v().xyz();
  std::optional<Parameter> first;
  for (int i = 0; i < 3; ++i) {
    if (v[i] == 0) continue;
    const double way = v[i] > 0 ? 1 : -1;
    double furthest = way * triangles[0].vertices[0][i];
    for (const scene::Triangle triangle : triangles) {
      for (const glm::dvec3& vertex : triangle.vertices) furthest = std::max(furthest, way * vertex[i]);
    }
    const Parameter t{.x = Dyadic(furthest) + grown - Dyadic(way * p[i]), .w = Dyadic(std::abs(v[i]))};
    if (!first || surface::exact::order(t, *first) < 0) first = t;
  }
  return *first;
}

}  // namespace

std::optional<Zone> zone_of_mesh(const scene::Scene& scene, const model::Rayo& rayo, const Precision& precision) {
  const Triangles triangles = scene.shapes<scene::Triangle>();
  if (triangles.empty() || !is_closed(triangles)) return std::nullopt;
  const glm::dvec3& p = rayo.p().xyz();
  double longest = largest(p);
  for (const scene::Triangle triangle : triangles) longest = std::max(longest, largest_length(triangle));
  const Allowance allowed(precision, Dyadic(2 + 0x1p-4) * Dyadic(longest), rayo);
  if (allowed.times(32) > Dyadic(longest)) return std::nullopt;
  const Point<Dyadic> origin{p.x, p.y, p.z};
  for (const scene::Triangle triangle : triangles) {
    if (may_hold(shell(triangle, origin, allowed, EndShift::outwards))) return std::nullopt;
  }
  if (!is_inside(triangles, rayo.p())) return std::nullopt;
  return Zone{{scene::Triangle::tipo, 0}, Parameter{}, leaving(triangles, rayo, allowed.times(4)), allowed.delta};
}

}  // namespace durero::conform
