#pragma once
/// A plain tracer of bodies, as a program has it, with one fault or none.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "durero/conform/ask/claim.hpp"
#include "durero/conform/families/suite.hpp"

namespace durero::test {

enum class BodyFault {
  none,
  binary32_arithmetic,       ///< in a system that claims binary64
  zero_times_infinity,       ///< a slab by products with 1/v, whose NaN ends the test of the others
  slab_parallel_by_epsilon,  ///< a ray is parallel to a slab where |v| < 1e-2
  slab_grown,                ///< by 1e-4
  slab_shrunk,
  slab_one_pair_left_out,  ///< z is not looked at
  far_side_first,          ///< of a box the exit is answered
  behind_the_origin,       ///< a negative t is answered
  inside_missed,           ///< a ray from inside sees nothing
  inside_at_the_origin,    ///< or is answered at the origin
  first_in_order,          ///< the first body that is met, not the nearest
  last_in_order,
  local_length,             ///< t in units of the body's own space
  local_direction_unit,     ///< v is made a unit vector there, and t not brought back
  least_t_1e_3,             ///< nothing is seen before
  least_t_1e_6,             ///< nor is there
  greatest_t_1e_6,          ///< nor behind
  transposed_map,           ///< its transpose in the place of its inverse
  map_without_shear,        ///< the lengths of the sides alone
  axes_of_coordinates,      ///< the box around the body's sides in its place
  determinant_by_epsilon,   ///< a map with a determinant below 1e-6 has no points
  mirrored_missed,          ///< nor has one that mirrors
  least_axis_for_all,       ///< an ellipsoid is a ball
  discriminant_by_epsilon,  ///< below 1e-6 there is no root
  discriminant_clamped,     ///< below 0 it is 0
  far_root_first,           ///< the larger root is answered
  capsule_without_top,
  capsule_without_ends,
  capsule_flat_ends,    ///< discs in the place of half balls
  capsule_inner_balls,  ///< the balls' inner halves are surface, too
  capsule_twice_as_long,
  capsule_along_z,         ///< the axis is another
  capsule_side_unbounded,  ///< a cylinder without ends
  rounded_sharp,           ///< a rounded box is one with sharp edges
  rounded_not_longer,      ///< or has no radius
  rounded_without_corners,
  rounded_without_edges,
  rounded_inner_edges,  ///< the cylinders of edges are surface inside, too
  torus_two_roots,      ///< of a torus the first two crossings of the whole line are looked at alone
  torus_without_hole,   ///< what its ring encloses is filled
  torus_apple,          ///< the plane's own coordinate is left out
  torus_newton          ///< one step of the secant is taken for the root
};

/// One body in the space in which it is a unit shape, or of a capsule as it stands.
class BodyTracer {
 public:
  BodyTracer(const std::vector<conform::NamedBody>& bodies, BodyFault fault) : bodies_(&bodies), fault_(fault) {}

  conform::Claim first_hit(const model::Rayo& rayo) const {
    conform::Claim nearest{.outcome = conform::Claim::Outcome::miss};
    for (const auto& [element, body] : *bodies_) {
      const std::optional<double> t = narrowed(first_of(body, rayo.p().xyz(), rayo.v().xyz()));
      if (!t) continue;
      const bool is_nearer = !nearest.t || *t < *nearest.t || is(BodyFault::last_in_order);
      if (is_nearer && !(nearest.t && is(BodyFault::first_in_order)))
        nearest = {.outcome = conform::Claim::Outcome::hit, .element = element, .t = t};
    }
    return nearest;
  }

 private:
  using Found = std::optional<double>;

  bool is(BodyFault fault) const { return fault_ == fault; }

  Found narrowed(Found t) const {
    if (!t || !is(BodyFault::binary32_arithmetic)) return t;
    return static_cast<double>(static_cast<float>(*t));
  }

  /// The first of the ends of a stretch that counts.
  Found first_of_stretch(double near, double far) const {
    double least = 0;
    if (is(BodyFault::least_t_1e_3)) least = 1e-3;
    if (is(BodyFault::least_t_1e_6)) least = 1e-6;
    if (is(BodyFault::behind_the_origin)) least = -std::numeric_limits<double>::infinity();
    if (is(BodyFault::far_side_first) || is(BodyFault::far_root_first)) std::swap(near, far);
    if (near <= 0 && far > 0 && is(BodyFault::inside_missed)) return std::nullopt;
    if (near <= 0 && far > 0 && is(BodyFault::inside_at_the_origin)) return 0;
    for (const double t : {near, far}) {
      if (t > least) return t > 1e6 && is(BodyFault::greatest_t_1e_6) ? std::nullopt : Found(t);
    }
    return std::nullopt;
  }

  /// The map with the fault, and its inverse.
  std::optional<glm::dmat3> inverse(const conform::AskedBody& body) const {
    glm::dmat3 map(body.sides[0], body.sides[1], body.sides[2]);
    // A scale that has no part in the faults keeps determinants within the range of numbers.
    const double unit = std::exp2(std::round(std::log2(longest_side(body))));
    const double determinant = glm::determinant(map / unit);
    if (is(BodyFault::determinant_by_epsilon) && std::abs(glm::determinant(map)) < 1e-6) return std::nullopt;
    if (is(BodyFault::mirrored_missed) && determinant < 0) return std::nullopt;
    if (is(BodyFault::transposed_map)) return glm::transpose(map);
    if (is(BodyFault::map_without_shear)) {
      for (int i = 0; i < 3; ++i) map[i] = glm::length(map[i]) * glm::dvec3(i == 0, i == 1, i == 2);
    }
    return glm::inverse(map / unit) / unit;
  }
  static double longest_side(const conform::AskedBody& body) {
    return std::max(
        {conform::length_of(body.sides[0]), conform::length_of(body.sides[1]), conform::length_of(body.sides[2])});
  }

  Found first_of(const conform::AskedBody& body, const glm::dvec3& p, const glm::dvec3& v) const {
    if (body.kind == conform::BodyKind::toro) return torus(body, p - body.centro, v);
    if (body.kind == conform::BodyKind::caja_redonda) return rounded_box(body, p - body.centro, v);
    if (body.kind == conform::BodyKind::capsula) return capsule(body, p - body.centro, v);
    const bool is_box = body.kind == conform::BodyKind::caja || body.kind == conform::BodyKind::copia_caja;
    if (is_box && is(BodyFault::axes_of_coordinates)) {
      glm::dvec3 half(0);
      for (const glm::dvec3& side : body.sides) half += glm::abs(side);
      return box((p - body.centro) / half, v / half);
    }
    if (!is_box && is(BodyFault::least_axis_for_all)) {
      const double r = std::min(
          {conform::length_of(body.sides[0]), conform::length_of(body.sides[1]), conform::length_of(body.sides[2])});
      return ball((p - body.centro) / r, v / r);
    }
    const auto to_local = inverse(body);
    if (!to_local) return std::nullopt;
    const glm::dvec3 q = *to_local * (p - body.centro);
    glm::dvec3 d = *to_local * v;
    if (is(BodyFault::local_direction_unit)) d /= glm::length(d);
    const Found t = is_box ? box(q, d) : ball(q, d);
    return t && is(BodyFault::local_length) ? Found(*t * glm::length(d)) : t;
  }

  Found box(const glm::dvec3& q, const glm::dvec3& d) const {
    double near = -std::numeric_limits<double>::infinity(), far = -near;
    const double half = is(BodyFault::slab_grown) ? 1 + 1e-4 : is(BodyFault::slab_shrunk) ? 1 - 1e-4 : 1;
    for (int i = 0; i < (is(BodyFault::slab_one_pair_left_out) ? 2 : 3); ++i) {
      const bool is_parallel = d[i] == 0 || (is(BodyFault::slab_parallel_by_epsilon) && std::abs(d[i]) < 1e-2);
      if (is_parallel && !is(BodyFault::zero_times_infinity)) {
        if (std::abs(q[i]) > half) return std::nullopt;
        continue;
      }
      double a = (-half - q[i]) / d[i], b = (half - q[i]) / d[i];
      if (is(BodyFault::zero_times_infinity)) {
        const double inverse = 1 / d[i];
        a = (-half - q[i]) * inverse, b = (half - q[i]) * inverse;
        if (std::isnan(a) || std::isnan(b)) break;
      }
      if (a > b) std::swap(a, b);
      near = std::max(near, a), far = std::min(far, b);
    }
    return near <= far ? first_of_stretch(near, far) : std::nullopt;
  }

  /// The stretch of a ray in a ball of radius 1, of the point of the ray that is nearest to its middle.
  std::optional<glm::dvec2> stretch_of_ball(const glm::dvec3& q, const glm::dvec3& d) const {
    const double a = glm::dot(d, d), t = -glm::dot(q, d) / a;
    const glm::dvec3 foot = q + t * d;
    double discriminant = 1 - glm::dot(foot, foot);
    if (is(BodyFault::discriminant_by_epsilon) && discriminant < 1e-6) return std::nullopt;
    if (is(BodyFault::discriminant_clamped)) discriminant = std::max(0.0, discriminant);
    if (!(discriminant >= 0)) return std::nullopt;
    const double half = std::sqrt(discriminant / a);
    return glm::dvec2(t - half, t + half);
  }
  Found ball(const glm::dvec3& q, const glm::dvec3& d) const {
    const auto stretch = stretch_of_ball(q, d);
    return stretch ? first_of_stretch(stretch->x, stretch->y) : std::nullopt;
  }

  /// The union of a cylinder and two balls: the least and the greatest end of their stretches, which overlap.
  Found capsule(const conform::AskedBody& body, glm::dvec3 q, glm::dvec3 v) const {
    const double r = conform::length_of(body.sides[0]);
    const glm::dvec3 y = body.sides[is(BodyFault::capsule_along_z) ? 2 : 1] / r;
    q /= r, v /= r;
    const double half = conform::length_of(y) * (is(BodyFault::capsule_twice_as_long) ? 2 : 1);
    const glm::dvec3 axis = y / conform::length_of(y);
    std::vector<glm::dvec2> stretches;
    if (const auto side = stretch_of_side(q, v, axis, half)) stretches.push_back(*side);
    if (!is(BodyFault::capsule_without_ends) && !is(BodyFault::capsule_flat_ends)) {
      for (const double end : {-1.0, 1.0}) {
        if (end > 0 && is(BodyFault::capsule_without_top)) continue;
        if (const auto of = stretch_of_ball(q - end * half * axis, v)) stretches.push_back(*of);
      }
    }
    if (stretches.empty()) return std::nullopt;
    glm::dvec2 all = stretches[0];
    for (const glm::dvec2& one : stretches) all = {std::min(all.x, one.x), std::max(all.y, one.y)};
    if (is(BodyFault::capsule_inner_balls)) {
      for (const glm::dvec2& one : stretches) {
        if (one.x > 0 && all.x <= 0) return one.x;
      }
    }
    return first_of_stretch(all.x, all.y);
  }

  /// The union of boxes, cylinders and balls, in the frame of the sides and in units of the radius.
  Found rounded_box(const conform::AskedBody& body, const glm::dvec3& p, const glm::dvec3& v) const {
    glm::dvec3 half, q, d;
    const double r = is(BodyFault::rounded_not_longer) ? 1e-3 * body.radio : body.radio;
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3& side = body.sides[static_cast<std::size_t>(i)];
      half[i] = conform::length_of(side);
      const glm::dvec3 axis = side / half[i];
      half[i] /= r, q[i] = glm::dot(p, axis) / r, d[i] = glm::dot(v, axis) / r;
    }
    std::vector<glm::dvec2> stretches;
    const auto take = [&](const std::optional<glm::dvec2>& one) {
      if (one) stretches.push_back(*one);
    };
    if (is(BodyFault::rounded_sharp)) take(stretch_of_slabs(q, d, half + 1.0));
    for (int i = 0; i < 3; ++i) {
      glm::dvec3 longer = half, axis(0);
      longer[i] += 1, axis[i] = 1;
      take(stretch_of_slabs(q, d, longer));
      for (int corner = 0; corner < 4 && !is(BodyFault::rounded_without_edges); ++corner) {
        glm::dvec3 middle(0);
        middle[(i + 1) % 3] = corner % 2 == 0 ? half[(i + 1) % 3] : -half[(i + 1) % 3];
        middle[(i + 2) % 3] = corner / 2 == 0 ? half[(i + 2) % 3] : -half[(i + 2) % 3];
        take(stretch_of_side(q - middle, d, axis, half[i]));
      }
    }
    for (int corner = 0; corner < 8 && !is(BodyFault::rounded_without_corners); ++corner) {
      const glm::dvec3 signs(corner % 2 == 0 ? 1 : -1, corner / 2 % 2 == 0 ? 1 : -1, corner / 4 == 0 ? 1 : -1);
      take(stretch_of_ball(q - signs * half, d));
    }
    if (stretches.empty()) return std::nullopt;
    glm::dvec2 all = stretches[0];
    for (const glm::dvec2& one : stretches) all = {std::min(all.x, one.x), std::max(all.y, one.y)};
    if (is(BodyFault::rounded_inner_edges) && all.x <= 0) {
      for (const glm::dvec2& one : stretches) {
        if (one.x > 0) return one.x;
      }
    }
    return first_of_stretch(all.x, all.y);
  }

  using Wide = long double;
  using Coefficients = std::array<Wide, 5>;

  static Wide value(const Coefficients& f, Wide t) {
    Wide sum = 0;
    for (std::size_t i = f.size(); i-- > 0;) sum = sum * t + f[i];
    return sum;
  }

  /// The roots of a polynomial of that degree in −2 … 2, between those of its derivative, ascending.
  std::vector<Wide> roots(const Coefficients& f, std::size_t degree) const {
    if (degree == 0) return {};
    Coefficients slope{};
    for (std::size_t i = 1; i <= degree; ++i) slope[i - 1] = static_cast<Wide>(i) * f[i];
    std::vector<Wide> places{-2};
    for (const Wide t : roots(slope, degree - 1)) places.push_back(t);
    places.push_back(2);
    std::vector<Wide> all;
    for (std::size_t i = 1; i < places.size(); ++i) {
      Wide low = places[i - 1], high = places[i], at_low = value(f, low), at_high = value(f, high);
      if (at_low == 0 && (all.empty() || all.back() != low)) all.push_back(low);
      if (at_low == 0 || (at_low < 0) == (at_high < 0)) continue;
      const int turns = degree == 4 && is(BodyFault::torus_newton) ? 3 : 90;
      for (int turn = 0; turn < turns; ++turn) {
        const Wide middle = (low + high) / 2, at = value(f, middle);
        ((at < 0) == (at_low < 0) ? low : high) = middle;
      }
      all.push_back((low + high) / 2);
    }
    return all;
  }

  /// In units of the ring's radius, around the point of the ray that is nearest to the middle and along a v of
  /// length 1.
  Found torus(const conform::AskedBody& body, const glm::dvec3& p, const glm::dvec3& v) const {
    using Wide3 = glm::vec<3, Wide>;
    const Wide R = conform::length_of(body.sides[0]), speed = conform::length_of(v), r = body.radio / R;
    const Wide3 x = Wide3(body.sides[0]) / R, z = Wide3(body.sides[2]) / R, n = glm::cross(x, z), u = Wide3(v) / speed;
    const Wide back = glm::dot(Wide3(p) / R, u);
    const Wide3 q = Wide3(p) / R - back * u;
    const Wide qq = glm::dot(q, q), qn = is(BodyFault::torus_apple) ? 0 : glm::dot(q, n), un = glm::dot(u, n);
    if (qq > (1 + r) * (1 + r)) return std::nullopt;
    const Wide c = qq + 1 - r * r;
    Coefficients f{c * c - 4 * (qq - qn * qn), 8 * qn * un, 2 * c - 4 * (1 - un * un), 0, 1};
    std::vector<double> all;
    for (const Wide t : roots(f, 4)) all.push_back(static_cast<double>((t - back) * (R / speed)));
    if (is(BodyFault::torus_two_roots)) all.resize(std::min<std::size_t>(all.size(), 2));
    if (is(BodyFault::torus_without_hole) && all.size() == 4) all.erase(all.begin() + 1, all.begin() + 3);
    double least = 0;
    if (is(BodyFault::least_t_1e_3)) least = 1e-3;
    if (is(BodyFault::least_t_1e_6)) least = 1e-6;
    if (is(BodyFault::behind_the_origin)) least = -std::numeric_limits<double>::infinity();
    for (const double t : all) {
      if (t > least) return t > 1e6 && is(BodyFault::greatest_t_1e_6) ? std::nullopt : Found(t);
    }
    return std::nullopt;
  }

  static std::optional<glm::dvec2> stretch_of_slabs(const glm::dvec3& q, const glm::dvec3& d, const glm::dvec3& half) {
    glm::dvec2 stretch(-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
    for (int i = 0; i < 3; ++i) {
      if (d[i] == 0 && std::abs(q[i]) > half[i]) return std::nullopt;
      if (d[i] == 0) continue;
      const double a = (-half[i] - q[i]) / d[i], b = (half[i] - q[i]) / d[i];
      stretch = {std::max(stretch.x, std::min(a, b)), std::min(stretch.y, std::max(a, b))};
    }
    return stretch.x <= stretch.y ? std::optional(stretch) : std::nullopt;
  }

  std::optional<glm::dvec2> stretch_of_side(const glm::dvec3& q, const glm::dvec3& v, const glm::dvec3& axis,
                                            double half) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double along = glm::dot(v, axis), at = glm::dot(q, axis);
    const glm::dvec3 across = v - along * axis, from = q - at * axis;
    glm::dvec2 stretch(-infinity, infinity);
    if (glm::dot(across, across) > 0x1p-100 * glm::dot(v, v)) {
      const auto round = stretch_of_ball(from, across);
      if (!round) return std::nullopt;
      stretch = *round;
    } else if (glm::dot(from, from) > 1) {
      return std::nullopt;
    }
    if (is(BodyFault::capsule_side_unbounded)) return stretch;
    if (along == 0) return std::abs(at) <= half ? std::optional(stretch) : std::nullopt;
    const double a = (-half - at) / along, b = (half - at) / along;
    stretch = {std::max(stretch.x, std::min(a, b)), std::min(stretch.y, std::max(a, b))};
    return stretch.x <= stretch.y ? std::optional(stretch) : std::nullopt;
  }

  const std::vector<conform::NamedBody>* bodies_;
  BodyFault fault_;
};

}  // namespace durero::test
