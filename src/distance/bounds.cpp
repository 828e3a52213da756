// One bound on all errors: a distance that is computed below is off by less than 512u, u = 2⁻⁵³, times the sum of the
// lengths that it is computed from. Differences, products and roots of a few roundings lose less than 64u each time.
// The rest is what the axis d is short of, or beyond, a unit vector, with |d·d − 1| ≤ 2⁻⁵⁰ = 8u. Let c = |1 − d·d|/|d|
// < 8.1u.
//   the advance   along the axis a point has the place s/|d|, off by less than 4.1u of the advance s
//   from the axis it has the distance |q − (s/dd)·d|, off by less than 8.1u of |q|
//   a ring        at the advance s has the radius √(R² − c²s²) (distance/turned.hpp), short by at most c·s of the R of
//   a
//                 straight profile: so it lies within 16u·altura of the profile's line
// No overflow or underflow changes that, by the precondition on magnitudes: squares lie within 2⁻⁵⁰⁰ … 2⁵⁰⁰, or are 0.
#include "durero/distance/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "durero/trace/ray.hpp"

namespace durero::distance {
namespace {

constexpr double share = 0x1p-44;  // 512u

bool is_ordinary(const glm::dvec3& p) { return trace::ordinary(scene::Sphere{p, 1}); }

double extent(const glm::dvec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// The bounds where the distance is computed from some lengths; high is `more` higher.
Bounds around(double distance, double lengths, double more = 0) {
  return {std::max(0.0, distance - share * lengths), distance + share * lengths + more};
}

Bounds of(const scene::Sphere& sphere, const glm::dvec3& p) {
  const double out = glm::length(p - sphere.centro);
  return around(std::abs(out - sphere.radio), out + sphere.radio);
}

Bounds of(const scene::Plane& plane, const glm::dvec3& p) {
  const glm::dvec3 q = p - plane.centro;
  return around(std::abs(glm::dot(q, plane.vector)), extent(q));
}

Bounds of(const scene::Disc& disc, const glm::dvec3& p) {
  const glm::dvec3 q = p - disc.centro;
  const double s = glm::dot(q, disc.vector), out = glm::length(q - s * disc.vector);
  return around(std::hypot(std::max(out - disc.radio, 0.0), s), extent(q) + disc.radio);
}

/// The profile as a line from the radius `base` at the centre to `top` at the altura. A ring is where R ≥ c·s. Where
/// top is not below c·altura all are. Else R = c·s at an advance s₀ with proporcion·(altura − s₀) ≤ c·altura, from
/// which what is missing of the line is farther by (altura − s₀)·√(1 + proporcion²) at most; the ring at the centre is
/// always there.
template <class Shape>
Bounds of_line(const Shape& e, double base, double top, double proporcion, const glm::dvec3& p) {
  const glm::dvec3 q = p - e.centro;
  const double s = glm::dot(q, e.vector), out = glm::length(q - s * e.vector) - base, slope = top - base;
  const double t = std::clamp((out * slope + s * e.altura) / (slope * slope + e.altura * e.altura), 0.0, 1.0);
  const double lengths = extent(q) + base + e.altura;
  const bool all = top >= 0x1p-48 * e.altura;
  const Bounds line = around(std::hypot(out - t * slope, s - t * e.altura), lengths,
                             all ? 0 : 0x1p-48 * e.altura * (1 + 1 / proporcion));
  return {line.low, std::min(line.high, around(std::hypot(out, s), lengths).high)};
}

Bounds of(const scene::Cylinder& e, const glm::dvec3& p) { return of_line(e, e.radio, e.radio, 0, p); }
Bounds of(const scene::Cone& e, const glm::dvec3& p) { return of_line(e, e.proporcion * e.altura, 0, e.proporcion, p); }
Bounds of(const scene::TruncatedCone& e, const glm::dvec3& p) {
  return of_line(e, e.radio + e.proporcion * e.altura, e.radio, e.proporcion, p);
}

/// The weights β, γ ≥ 0 with β + γ ≤ 1 of a point a + β·e1 + γ·e2 near q: that on the plane, or on an edge.
struct Weights {
  double beta, gamma;
};
Weights weights(const glm::dvec3& e1, const glm::dvec3& e2, const glm::dvec3& q) {
  const glm::dvec3 n = glm::cross(e1, e2);
  const double nn = glm::dot(n, n), beta = glm::dot(glm::cross(q, e2), n) / nn,
               gamma = glm::dot(glm::cross(e1, q), n) / nn;
  if (beta >= 0 && gamma >= 0 && beta + gamma <= 1) return {beta, gamma};
  const auto along = [](const glm::dvec3& edge, const glm::dvec3& from) {
    return std::clamp(glm::dot(from, edge) / glm::dot(edge, edge), 0.0, 1.0);
  };
  const double third = along(e2 - e1, q - e1);
  const Weights edges[] = {{along(e1, q), 0}, {0, along(e2, q)}, {1 - third, third}};
  const auto away = [&](const Weights& w) { return glm::length(q - (w.beta * e1 + w.gamma * e2)); };
  return *std::ranges::min_element(edges, {}, away);
}

/// Any point of the triangle bounds the distance from above. From below any direction n of length one does: each point
/// w of the triangle is p − w away at least by n·(p − w), and that is least at a vertex. The direction to the point
/// found is the best one. NaN weights, of a triangle too thin, leave the bounds open.
Bounds of(const scene::Triangle& triangle, const glm::dvec3& p) {
  const auto& [a, b, c] = triangle.vertices;
  const glm::dvec3 e1 = b - a, e2 = c - a, q = p - a;
  const auto [beta, gamma] = weights(e1, e2, q);
  const glm::dvec3 way = q - (beta * e1 + gamma * e2);
  const double length = glm::length(way), lengths = extent(q) + extent(e1) + extent(e2);
  if (!(length <= lengths)) return {};
  if (length == 0) return around(0, lengths);
  const double least = std::min({glm::dot(way, q), glm::dot(way, q - e1), glm::dot(way, q - e2)}) / length;
  return {around(least, lengths).low, around(length, lengths).high};
}

}  // namespace

Bounds bounds(scene::ShapeView shape, const glm::dvec3& p) {
  if (!is_ordinary(p) || !trace::ordinary(shape)) return {};
  return shape.visit([&](const auto& of_type) { return of(of_type, p); });
}

// Three differences, squares and sums and a root lose less than 8u; a square that underflows loses what is not lost of
// an ordinary point, and the next number below 0 is 0.
double least_distance(const surface::Box& box, const glm::dvec3& p) {
  if (!is_ordinary(p)) return 0;
  const glm::dvec3 gap = glm::max(glm::max(box.low - p, p - box.high), glm::dvec3(0));
  return glm::length(gap) * (1 - 0x1p-48);
}

}  // namespace durero::distance
