#include "conform/judge/closed_mesh.hpp"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <vector>

#include "conform/judge/near_box.hpp"
#include "conform/judge/shell.hpp"
#include "durero/surface/exact_element.hpp"
#include "durero/trace/search.hpp"

namespace durero::conform {
namespace {

using number::sign;
using scene::Triangles;
using surface::exact::Parameter;

Triangles triangles_of(const SceneTree& tree) { return tree.scene().shapes<scene::Triangle>(); }

/// Whether the triangles are a closed mesh: every edge belongs to an even number of them.
bool is_closed(const Triangles& triangles) {
  using Vertex = std::array<double, 3>;
  using Edge = std::array<Vertex, 2>;
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const scene::Triangle triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 &a = triangle.vertices[i], &b = triangle.vertices[(i + 1) % 3];
      Edge& edge = edges.emplace_back(Edge{Vertex{a.x, a.y, a.z}, Vertex{b.x, b.y, b.z}});
      std::sort(edge.begin(), edge.end());
    }
  }
  std::sort(edges.begin(), edges.end());
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto next = std::find_if(edge, edges.end(), [&](const Edge& other) { return other != *edge; });
    if ((next - edge) % 2 != 0) return false;
    edge = next;
  }
  return true;
}

/// Whether the ray crosses an odd number of the triangles; nothing where it meets an edge, or lies in the plane of a
/// triangle that it may meet.
std::optional<bool> crosses_odd_number(const SceneTree& tree, const model::Rayo& rayo) {
  const Triangles triangles = triangles_of(tree);
  bool is_odd = false, is_clear = true;
  const auto cross = [&](scene::ElementRef element) {
    if (element.tipo != scene::Triangle::tipo || !is_clear) return;
    const surface::exact::Coefficients f = surface::exact::coefficients(triangles[element.index], rayo);
    if (sign(f.B) == 0 && sign(f.C) == 0) is_clear = false;
    if (sign(f.B) * sign(f.C) >= 0) return;  // no root is ahead
    int lowest = 1;
    for (const auto& bound : f.bounds) lowest = std::min(lowest, sign(bound.C));
    if (lowest == 0) is_clear = false;
    is_odd = is_odd != (lowest > 0);
  };
  tree.along(
      trace::Ray(rayo), {}, [] { return trace::no_limit; }, cross);
  return is_clear ? std::optional(is_odd) : std::nullopt;
}

/// Whether p lies strictly inside the closed mesh, by the parity of crossings of a ray from p. The fixed directions lie
/// along no edge of a mesh but by design; where each of them meets an edge, the answer is no.
bool is_inside(const SceneTree& tree, const model::Punto& p) {
  static constexpr std::array<glm::dvec3, 4> directions{
      {{1009, -709, 307}, {-419, 877, 1103}, {641, 211, -1301}, {-953, -547, 773}}};
  for (const glm::dvec3& direction : directions) {
    if (const auto is_odd = crosses_odd_number(tree, {p, model::Vector(direction)})) return *is_odd;
  }
  return false;
}

/// Whether the origin may be on some triangle, for some data.
bool may_be_on_some(const SceneTree& tree, const glm::dvec3& p, const Allowance& allowed) {
  const NearBox near{p, bound_above(allowed.times(8))};
  const Point<Dyadic> origin{p.x, p.y, p.z};
  for (const scene::Triangle triangle : triangles_of(tree)) {
    if (near.may_be_of(surface::box(triangle)) && may_hold(shell(triangle, origin, allowed, EndShift::outwards)))
      return true;
  }
  return false;
}

/// The parameter at which the ray leaves the box, grown by `grown` on every side. Precondition: the ray starts in that
/// box.
Parameter leaving(const surface::Box& box, const model::Rayo& rayo, const Dyadic& grown) {
  const glm::dvec3 &p = rayo.p().xyz(), &v = rayo.v().xyz();
  std::optional<Parameter> first;
  for (int i = 0; i < 3; ++i) {
    if (v[i] == 0) continue;
    const double way = v[i] > 0 ? 1 : -1, furthest = v[i] > 0 ? box.high[i] : -box.low[i];
    const Parameter t{.x = Dyadic(furthest) + grown - Dyadic(way * p[i]), .w = Dyadic(std::abs(v[i]))};
    if (!first || surface::exact::order(t, *first) < 0) first = t;
  }
  return *first;
}

}  // namespace

std::optional<ClosedMesh> closed_mesh(const SceneTree& tree) {
  const Triangles triangles = triangles_of(tree);
  if (triangles.empty() || !is_closed(triangles)) return std::nullopt;
  const glm::dvec3 first = triangles[0].vertices[0];
  ClosedMesh mesh{&tree, {first, first}, 0};
  for (const scene::Triangle triangle : triangles) {
    mesh.longest = std::max(mesh.longest, largest_length(triangle));
    const surface::Box box = surface::box(triangle);
    mesh.box = {glm::min(mesh.box.low, box.low), glm::max(mesh.box.high, box.high)};
  }
  return mesh;
}

std::optional<Zone> zone_of(const ClosedMesh& mesh, const model::Rayo& rayo, const Precision& precision) {
  const glm::dvec3& p = rayo.p().xyz();
  const double longest = std::max(mesh.longest, largest(p));
  const Allowance allowed(precision, Dyadic(2 + 0x1p-4) * Dyadic(longest), rayo);
  if (allowed.times(32) > Dyadic(longest)) return std::nullopt;
  if (may_be_on_some(*mesh.tree, p, allowed) || !is_inside(*mesh.tree, rayo.p())) return std::nullopt;
  return Zone{{scene::Triangle::tipo, 0}, Parameter{}, leaving(mesh.box, rayo, allowed.times(4)), allowed.delta};
}

}  // namespace durero::conform
