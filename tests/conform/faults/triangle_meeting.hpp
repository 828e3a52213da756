#pragma once
/// Tests of a ray against one triangle, in three styles: Möller and Trumbore's, Woop's watertight one, and Plücker
/// coordinates. The first has a fault where it is given one.

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "conform/faults/tree_fault.hpp"
#include "durero/number/dyadic.hpp"
#include "durero/number/quotient.hpp"
#include "durero/scene/shape/triangle.hpp"

namespace durero::test {

enum class TriangleStyle { moller_trumbore, woop, pluecker };
enum class TriangleNumbers { binary64, exact };

/// A ray in the numbers of a style.
template <class N>
struct PlainRay {
  glm::vec<3, N> p, v;
};

template <class N>
using PlainCorners = std::array<glm::vec<3, N>, 3>;

template <class N>
PlainCorners<N> plain(const scene::Corners& vertices) {
  return {glm::vec<3, N>(vertices[0]), glm::vec<3, N>(vertices[1]), glm::vec<3, N>(vertices[2])};
}

/// The numbers that Möller and Trumbore's test computes before it decides.
template <class N>
struct Barycentric {
  N det, u, v, t;  ///< u, v and t are quotients
};
template <class N>
Barycentric<N> barycentric(const PlainRay<N>& ray, const PlainCorners<N>& at) {
  const auto e1 = at[1] - at[0], e2 = at[2] - at[0], s = ray.p - at[0];
  const auto h = glm::cross(ray.v, e2), q = glm::cross(s, e1);
  const N det = glm::dot(e1, h);
  return {det, glm::dot(s, h) / det, glm::dot(ray.v, q) / det, glm::dot(e2, q) / det};
}

/// A quotient, which the styles below leave undivided: over Dyadic it is exact.
template <class N>
struct Fraction {
  N over, under;
};

template <class N>
int sign_of(const N& x) {
  return x < N(0) ? -1 : x > N(0) ? 1 : 0;
}

template <class N>
struct PlainVector {
  N x, y, z;
  friend PlainVector operator-(const PlainVector& a, const PlainVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
};
template <class N>
N dot(const PlainVector<N>& a, const PlainVector<N>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class N>
PlainVector<N> cross(const PlainVector<N>& a, const PlainVector<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A ray and a triangle in the numbers of a style, the triangle's vertices as they lie from the origin.
template <class N>
struct SeenTriangle {
  PlainVector<N> v;
  std::array<PlainVector<N>, 3> q;

  SeenTriangle(const glm::dvec3& p, const glm::dvec3& along, const scene::Corners& at) : v(number(along)) {
    for (std::size_t i = 0; i < 3; ++i) q[i] = number(at[i]) - number(p);
  }
  static PlainVector<N> number(const glm::dvec3& a) { return {N(a.x), N(a.y), N(a.z)}; }
};

/// Möller and Trumbore's test, undivided.
template <class N>
std::optional<Fraction<N>> moller_trumbore(const SeenTriangle<N>& seen) {
  const auto e1 = seen.q[1] - seen.q[0], e2 = seen.q[2] - seen.q[0], s = PlainVector<N>{} - seen.q[0];
  const auto h = cross(seen.v, e2), q = cross(s, e1);
  const N det = dot(e1, h), u = dot(s, h), v = dot(seen.v, q);
  const int sign = sign_of(det);
  if (sign == 0 || sign * sign_of(u) < 0 || sign * sign_of(v) < 0 || sign * sign_of(N(det - u - v)) < 0)
    return std::nullopt;
  return Fraction<N>{dot(e2, q), det};
}

/// Woop, Benthin and Wald's test, sheared without a division: edges that triangles share get the same numbers from
/// both.
template <class N>
std::optional<Fraction<N>> woop(const SeenTriangle<N>& seen) {
  const std::array<N, 3> v{seen.v.x, seen.v.y, seen.v.z};
  std::size_t z = 0;
  for (std::size_t i = 1; i < 3; ++i) z = v[i] * v[i] > v[z] * v[z] ? i : z;
  const std::size_t x = (z + 1) % 3, y = (z + 2) % 3;
  std::array<PlainVector<N>, 3> q;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<N, 3> from{seen.q[i].x, seen.q[i].y, seen.q[i].z};
    q[i] = {from[x] * v[z] - v[x] * from[z], from[y] * v[z] - v[y] * from[z], from[z]};
  }
  const auto edge = [](const auto& a, const auto& b) -> N { return a.x * b.y - a.y * b.x; };
  const N a = edge(q[2], q[1]), b = edge(q[0], q[2]), c = edge(q[1], q[0]);
  const bool is_negative = sign_of(a) < 0 || sign_of(b) < 0 || sign_of(c) < 0;
  const bool is_positive = sign_of(a) > 0 || sign_of(b) > 0 || sign_of(c) > 0;
  const N det = a + b + c;
  if ((is_negative && is_positive) || sign_of(det) == 0) return std::nullopt;
  return Fraction<N>{a * q[0].z + b * q[1].z + c * q[2].z, det * v[z]};
}

/// The test by the sides on which the ray passes the edges.
template <class N>
std::optional<Fraction<N>> pluecker(const SeenTriangle<N>& seen) {
  bool is_negative = false, is_positive = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = sign_of(dot(seen.v, cross(seen.q[(i + 1) % 3], seen.q[i])));
    is_negative = is_negative || side < 0, is_positive = is_positive || side > 0;
  }
  const auto normal = cross(seen.q[1] - seen.q[0], seen.q[2] - seen.q[0]);
  const N slope = dot(normal, seen.v);
  if ((is_negative && is_positive) || sign_of(slope) == 0) return std::nullopt;
  return Fraction<N>{dot(normal, seen.q[0]), slope};
}

template <class N>
std::optional<Fraction<N>> met_in_style(TriangleStyle style, const SeenTriangle<N>& seen) {
  switch (style) {
    case TriangleStyle::moller_trumbore:
      return moller_trumbore(seen);
    case TriangleStyle::woop:
      return woop(seen);
    case TriangleStyle::pluecker:
      return pluecker(seen);
  }
  throw std::logic_error("no such style");
}

/// The plane equation in binary32, without a step through the vertex.
inline long double t_of_plane(const PlainRay<float>& ray, const PlainCorners<float>& at) {
  const auto normal = glm::cross(at[1] - at[0], at[2] - at[0]);
  return (glm::dot(normal, at[0]) - glm::dot(normal, ray.p)) / glm::dot(normal, ray.v);
}

/// The parameter at which a right tracer of that style meets the triangle, rounded once where its numbers are exact.
inline std::optional<double> right_meeting(TriangleStyle style, TriangleNumbers numbers, const glm::dvec3& p,
                                           const glm::dvec3& v, const scene::Corners& at) {
  if (numbers == TriangleNumbers::binary64) {
    const auto met = met_in_style(style, SeenTriangle<double>(p, v, at));
    return met ? std::optional(met->over / met->under) : std::nullopt;
  }
  auto met = met_in_style(style, SeenTriangle<number::Dyadic>(p, v, at));
  if (!met) return std::nullopt;
  return number::round_quotient(met->over, met->under);
}

/// The place and size of a scene, for the faults that look at all of it.
struct SceneExtent {
  glm::dvec3 middle{};
  double size = 1;
};

/// The parameter at which a tracer with the fault meets the triangle.
inline std::optional<long double> meeting(TreeFault fault, const PlainRay<long double>& ray, const scene::Corners& at,
                                          const SceneExtent& extent) {
  using enum TreeFault;
  using Wide = long double;
  const auto narrow = [](const auto& v) { return glm::vec3(v); };
  const PlainRay<float> single{narrow(ray.p), narrow(ray.v)};
  if (fault == pluecker_in_binary32) {
    const auto met = pluecker(SeenTriangle<float>(glm::dvec3(ray.p), glm::dvec3(ray.v), at));
    return met ? std::optional<Wide>(met->over / met->under) : std::nullopt;
  }
  PlainCorners<Wide> corners = plain<Wide>(at);
  PlainRay<Wide> seen = ray;
  if (fault == vertices_from_the_middle_in_binary32) {
    for (std::size_t i = 0; i < 3; ++i) corners[i] = glm::vec<3, Wide>(narrow(at[i] - extent.middle));
    seen.p = glm::vec<3, Wide>(narrow(glm::dvec3(ray.p) - extent.middle));
  }
  Barycentric<Wide> b = barycentric(seen, corners);
  if (fault == matrix_in_binary32) {
    const Barycentric<float> rough = barycentric(single, plain<float>(at));
    b = {rough.det, rough.u, rough.v, rough.t};
  }
  const auto e1 = corners[1] - corners[0], e2 = corners[2] - corners[0];
  const Wide most = glm::length(e1) * glm::length(e2) * glm::length(ray.v), magnitude = std::abs(b.det);
  if (fault == nan_is_the_nearest && b.det == 0) return std::numeric_limits<Wide>::quiet_NaN();
  if (b.det == 0 || (fault == determinant_1e_6 && magnitude < 1e-6L) ||
      (fault == determinant_1e_12 && magnitude < 1e-12L) ||
      (fault == determinant_of_the_size && magnitude < 1e-3L * most) || (fault == back_faces_culled && b.det < 0) ||
      (fault == front_faces_culled && b.det > 0))
    return std::nullopt;
  if (fault == determinant_sign_lost && b.det < 0) b.u = -b.u, b.v = -b.v;
  if (fault == second_coordinate_for_the_first) b.u = b.v;
  const Wide least = fault == edges_outside_1e_3   ? -1e-3L
                     : fault == edges_inside_1e_5  ? 1e-5L
                     : fault == edges_inside_1e_12 ? 1e-12L
                                                   : 0;
  const Wide whole = fault == sum_beyond_one ? 1.001L : 1 - least;
  if (!(b.u >= least && b.v >= least && b.u + b.v <= whole)) return std::nullopt;
  const Wide length = glm::length(ray.v), size = extent.size;
  if (fault == plane_in_binary32) b.t = t_of_plane(single, plain<float>(at));
  if (fault == t_a_little_behind && b.t > -1e-3L && b.t <= 0) return 0x1p-60L;
  if (fault == t_at_least_1e_3 && b.t < 1e-3L) return std::nullopt;
  if (fault == t_at_most_1e_5 && b.t > 1e5L) return std::nullopt;
  if (fault == t_at_least_1e_5_of_the_scene && b.t * length < 1e-5L * size) return std::nullopt;
  if (fault == origin_on_it_is_no_hit) {
    const auto normal = glm::normalize(glm::cross(e1, e2));
    if (std::abs(glm::dot(normal, ray.p - corners[0])) < 1e-9L * size) return std::nullopt;
  }
  return b.t;
}

}  // namespace durero::test
