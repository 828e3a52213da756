#include "durero/mesh/side.hpp"

#include <algorithm>
#include <vector>

#include "durero/number/ball.hpp"
#include "hull.hpp"
#include "orientation.hpp"
#include "require_vertices.hpp"
#include "space_step.hpp"

namespace durero::mesh {
namespace {

using number::Dyadic;
using number::RealBall;

bool are_edges_even(std::span<const CornerNumbers> faces) {
  std::vector<EdgeEnds> edges;
  edges.reserve(3 * faces.size());
  for (const CornerNumbers& face : faces)
    for (std::size_t n = 0; n < 3; ++n)
      edges.push_back({std::min(face[n], face[(n + 1) % 3]), std::max(face[n], face[(n + 1) % 3])});
  std::ranges::sort(edges);
  for (auto begin = edges.begin(); begin != edges.end();) {
    const auto end = std::upper_bound(begin, edges.end(), *begin);
    if ((end - begin) % 2 != 0) return false;
    begin = end;
  }
  return true;
}

/// Whether each face is a triangle, and each edge has an even number of them (pares.def.1).
bool bound_something(std::span<const glm::dvec3> vertices, std::span<const CornerNumbers> faces) {
  return are_edges_even(faces) && std::ranges::none_of(faces, [&](const CornerNumbers& face) {
           return are_collinear(vertices[face[0]], vertices[face[1]], vertices[face[2]]);
         });
}

/// The sign of a number that formula(Number()) computes by numbers of that type: by enclosures where they can decide.
template <class Formula>
int exact_sign(const Formula& formula) {
  const int quick = sign(formula.template operator()<RealBall>());
  return quick != 0 ? quick : sign(formula.template operator()<Dyadic>());
}

/// On which side of p and q, seen along x, a point stands that is moved from w by ε along y and by ε² along z, for
/// every ε > 0 that is small enough; 0 where p and q are one point so seen. The area that w has with them decides, or
/// else how it changes with ε, or with ε².
int turn_about(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& w) {
  const int turn = exact_sign([&]<class Number>() {
    const SpaceStep<Number> edge(p, q), way(p, w);
    return edge.y * way.z - edge.z * way.y;
  });
  if (turn != 0) return turn;
  if (p.z != q.z) return p.z > q.z ? 1 : -1;
  return q.y > p.y ? 1 : q.y < p.y ? -1 : 0;
}

/// On which side of the plane of a face a point stands: 1 where the face turns to the left as it is seen from there.
int side_of_plane(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& w) {
  return exact_sign([&]<class Number>() {
    return dot(cross(SpaceStep<Number>(a, b), SpaceStep<Number>(a, c)), SpaceStep<Number>(a, w));
  });
}

/// Whether the ray towards greater x meets a face, from the point that turn_about() tells of. That ray meets no edge.
/// The point w is on no face, so that it is not in the plane of one that the ray meets.
bool is_ahead(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& w) {
  const int turn = turn_about(a, b, w);
  return turn != 0 && turn_about(b, c, w) == turn && turn_about(c, a, w) == turn && side_of_plane(a, b, c, w) == -turn;
}

/// A face as the ray towards greater x sees it.
struct SeenFace {
  glm::dvec3 a, b, c;

  bool may_be_met(const glm::dvec3& w) const {
    const auto [least_y, greatest_y] = std::minmax({a.y, b.y, c.y});
    const auto [least_z, greatest_z] = std::minmax({a.z, b.z, c.z});
    return std::max({a.x, b.x, c.x}) >= w.x && least_y <= w.y && w.y <= greatest_y && least_z <= w.z &&
           w.z <= greatest_z;
  }
  bool has(const glm::dvec3& w) const {
    return std::min({a.x, b.x, c.x}) <= w.x && side_of_plane(a, b, c, w) == 0 && Hull({a, b, c}).contains(w);
  }
};

}  // namespace

std::optional<Side> side_of(std::span<const glm::dvec3> vertices, std::span<const CornerNumbers> faces,
                            const glm::dvec3& point) {
  require_vertices(vertices.size(), faces);
  bool is_odd = false;
  for (const CornerNumbers& face : faces) {
    const SeenFace seen{vertices[face[0]], vertices[face[1]], vertices[face[2]]};
    if (!seen.may_be_met(point)) continue;
    if (seen.has(point)) return Side::on_surface;
    is_odd ^= is_ahead(seen.a, seen.b, seen.c, point);
  }
  if (!bound_something(vertices, faces)) return std::nullopt;
  return is_odd ? Side::inside : Side::outside;
}

}  // namespace durero::mesh
