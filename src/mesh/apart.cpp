#include "apart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace durero::mesh {
namespace {

/// A computed number, and what it may be off by. The bounds hold where no product is so small that it is rounded as a
/// subnormal, which is_moderate() sees to; where one is infinite or no number, no comparison holds.
struct Bounded {
  double value, off;
  int sign() const { return value > off ? 1 : value < -off ? -1 : 0; }
};

/// Coordinates that are 0 or in 2⁻²⁰⁰ … 2²⁰⁰. A difference of two is 0 or at least 2⁻²⁵², and a product of three of
/// these 2⁻⁷⁵⁶.
bool is_moderate(const FewPoints& points) {
  return std::ranges::all_of(points, [](const glm::dvec3& p) {
    return std::ranges::all_of(std::array{p.x, p.y, p.z},
                               [](double c) { return c == 0 || (std::abs(c) >= 0x1p-200 && std::abs(c) <= 0x1p+200); });
  });
}

/// direction · (p − origin). A term has the roundings of its difference, its product and two sums, at most 4 of 2⁻⁵³
/// each, so that the sum is off by less than 8 · 2⁻⁵³ times the terms' magnitudes, which are computed as nearly. A
/// direction may have a component so small that a product is subnormal: it is taken as 0.
Bounded advance_of(const glm::dvec3& direction, const glm::dvec3& origin, const glm::dvec3& p) {
  const glm::dvec3 terms = direction * (p - origin);
  return {terms.x + terms.y + terms.z, 0x1p-50 * (std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z))};
}

/// Six times the volume between four points. Each of its six terms has at most eight roundings: three of differences,
/// two of products and three of sums; so the sum is off by less than 16 · 2⁻⁵³ times the terms' magnitudes.
Bounded volume_of(const glm::dvec3& o, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 u = a - o, v = b - o, w = c - o, s = glm::abs(u), t = glm::abs(v), r = glm::abs(w);
  const double value = u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) + u.z * (v.x * w.y - v.y * w.x);
  const double terms = s.x * (t.y * r.z + t.z * r.y) + s.y * (t.z * r.x + t.x * r.z) + s.z * (t.x * r.y + t.y * r.x);
  return {value, 0x1p-49 * terms};
}

/// Twice the area between three points, seen along an axis: two terms of at most four roundings each.
Bounded area_of(const glm::dvec3& o, const glm::dvec3& a, const glm::dvec3& b, int axis) {
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;
  const double left = (a[x] - o[x]) * (b[y] - o[y]), right = (a[y] - o[y]) * (b[x] - o[x]);
  return {left - right, 0x1p-50 * (std::abs(left) + std::abs(right))};
}

/// A direction whose components are 0 or in 2⁻⁶⁰⁰ … 2⁶⁰⁰: any direction may be tried.
glm::dvec3 tame(glm::dvec3 direction) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::abs(direction[axis]) >= 0x1p-600)) direction[axis] = 0;
  return direction;
}

/// Whether every point of the one set is before every point of the other in a direction.
bool are_before(const glm::dvec3& direction, const FewPoints& before, const FewPoints& behind) {
  double greatest = -std::numeric_limits<double>::infinity(), least = -greatest;
  for (const glm::dvec3& p : before) {
    const Bounded advance = advance_of(direction, before[0], p);
    greatest = std::max(greatest, advance.value + 2 * advance.off);  // twice, for the roundings of this sum
  }
  for (const glm::dvec3& p : behind) {
    const Bounded advance = advance_of(direction, before[0], p);
    least = std::min(least, advance.value - 2 * advance.off);
  }
  return greatest < least;
}

bool part(const glm::dvec3& direction, const FewPoints& a, const FewPoints& b) {
  const glm::dvec3 tried = tame(direction);
  return are_before(tried, a, b) || are_before(-tried, a, b);
}

using Directions = boost::container::static_vector<glm::dvec3, 3>;

Directions edges_of(const FewPoints& face) { return {face[1] - face[0], face[2] - face[1], face[0] - face[2]}; }

/// Faces without a common corner: a plane between them is parallel to one of them, to an edge of each, or stands on the
/// plane of both upon an edge.
bool are_separate(const FewPoints& a, const FewPoints& b) {
  if (a.size() < 3 || b.size() < 3) return false;
  const Directions of_a = edges_of(a), of_b = edges_of(b);
  const glm::dvec3 m = glm::cross(of_a[0], of_a[1]), n = glm::cross(of_b[0], of_b[1]);
  if (part(m, a, b) || part(n, a, b)) return true;
  for (const glm::dvec3& u : of_a)
    for (const glm::dvec3& v : of_b)
      if (part(glm::cross(u, v), a, b)) return true;
  return std::ranges::any_of(of_a, [&](const glm::dvec3& u) { return part(glm::cross(m, u), a, b); }) ||
         std::ranges::any_of(of_b, [&](const glm::dvec3& v) { return part(glm::cross(n, v), a, b); });
}

glm::dvec3 middle_direction(const glm::dvec3& from, const FewPoints& to) {
  glm::dvec3 sum(0);
  for (const glm::dvec3& p : to) sum += glm::normalize(p - from);
  return sum;
}

bool are_all_behind(const glm::dvec3& direction, const glm::dvec3& origin, const FewPoints& points) {
  return std::ranges::all_of(points, [&](const glm::dvec3& p) { return advance_of(direction, origin, p).sign() > 0; });
}

/// Whether a face, that has p, leaves the plane of p and two others at p on one side.
bool lie_on_one_side(const glm::dvec3& p, const FewPoints& plane, const FewPoints& face) {
  const int side = volume_of(p, plane[0], plane[1], face[0]).sign();
  return side != 0 && volume_of(p, plane[0], plane[1], face[1]).sign() == side;
}

/// Whether an edge passes the corner p of a face on the outside, where it crosses the plane of the face.
bool passes_beside(const FewPoints& edge, const glm::dvec3& p, const FewPoints& face) {
  return volume_of(edge[0], edge[1], p, face[0]).sign() * volume_of(edge[0], edge[1], face[1], p).sign() < 0;
}

/// Faces with one common corner: a plane through it parts them; it may be that of one of them.
bool are_apart_but_for(const glm::dvec3& p, const FewPoints& a, const FewPoints& b) {
  const glm::dvec3 direction = tame(middle_direction(p, b) - middle_direction(p, a));
  if (are_all_behind(direction, p, b) && are_all_behind(-direction, p, a)) return true;
  if (a.size() < 2 || b.size() < 2) return false;
  return lie_on_one_side(p, a, b) || lie_on_one_side(p, b, a) || passes_beside(a, p, b) || passes_beside(b, p, a);
}

/// Faces with a common edge: they lie in two planes, or on two sides of it, as it is seen along some axis.
bool are_apart_but_for(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& a, const glm::dvec3& b) {
  if (volume_of(p, q, a, b).sign() != 0) return true;
  for (int axis = 0; axis < 3; ++axis)
    if (area_of(p, q, a, axis).sign() * area_of(p, q, b, axis).sign() < 0) return true;
  return false;
}

}  // namespace

bool are_surely_apart(const SharedCorners& corners) {
  const auto& [both, a, b] = corners;
  if (!is_moderate(both) || !is_moderate(a) || !is_moderate(b)) return false;
  switch (both.size()) {
    case 0:
      return are_separate(a, b);
    case 1:
      return are_apart_but_for(both[0], a, b);
    case 2:
      return are_apart_but_for(both[0], both[1], a[0], b[0]);
  }
  return false;
}

}  // namespace durero::mesh
