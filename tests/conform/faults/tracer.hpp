#pragma once
/// An ordinary tracer of plain arithmetic, over float or double, as a careful author writes it: every step is stable,
/// so that its answers are those of data off by a few roundings. With one fault, where it is given one.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "conform/faults/fault.hpp"
#include "durero/conform/ask/claim.hpp"
#include "durero/scene/scene.hpp"

namespace durero::test {

template <class N>
class Tracer {
 public:
  using V = glm::vec<3, N>;

  explicit Tracer(const scene::Scene& scene, Fault fault = Fault::none) : scene_(scene), fault_(fault) {}

  conform::Claim first_hit(const model::Rayo& rayo) const {
    const Line line = line_of(rayo);
    conform::Claim nearest{.outcome = conform::Claim::Outcome::miss};
    scene_.for_each([&](scene::ElementRef element, const auto& shape) {
      const std::optional<N> t = first_of(shape, line);
      if (!t || (nearest.t && !is_nearer(*t, *nearest.t))) return;
      nearest = {.outcome = conform::Claim::Outcome::hit, .element = element, .t = static_cast<double>(*t)};
    });
    if (nearest.t) nearest.t = is(Fault::t_rounded_to_binary32) ? double{static_cast<float>(*nearest.t)} : *nearest.t;
    if (!nearest.t && is(Fault::nan_for_a_miss))
      return {.outcome = conform::Claim::Outcome::hit, .t = std::numeric_limits<double>::quiet_NaN()};
    return nearest;
  }

 private:
  /// A ray, its v scaled by 2^−places so that no square of it overflows.
  struct Line {
    V p, v;
    int places = 0;
  };
  /// Parameters in ascending order, in units of the line's v; a NaN is none.
  using Roots = std::array<N, 2>;
  static constexpr N none = std::numeric_limits<N>::quiet_NaN();

  bool is(Fault fault) const { return fault_ == fault; }
  bool is_nearer(N t, double than) const {
    if (is(Fault::first_in_order)) return false;
    return is(Fault::last_in_distance) ? static_cast<double>(t) > than : static_cast<double>(t) < than;
  }

  Line line_of(const model::Rayo& rayo) const {
    Line line{V(rayo.p().xyz()), V(rayo.v().xyz())};
    const V& v = line.v;
    const N longest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    std::frexp(longest, &line.places);
    for (int i = 0; i < 3; ++i) line.v[i] = std::ldexp(line.v[i], -line.places);
    if (is(Fault::origin_ignored)) line.p = V(0);
    if (is(Fault::v_normalised_alone)) {
      line.v /= glm::length(line.v);
      line.places = 0;
    }
    if (is(Fault::unit_v_assumed)) line = {line.p, V(rayo.v().xyz()), 0};
    return line;
  }

  /// What a t must be: ahead of the origin.
  bool is_ahead(N t, N size) const {
    switch (fault_) {
      case Fault::least_t_1e_3:
        return t > N(1e-3);
      case Fault::least_t_1e_4:
        return t > N(1e-4);
      case Fault::least_t_1e_6:
        return t > N(1e-6);
      case Fault::least_t_of_size:
        return t > N(1e-6) * size;
      case Fault::greatest_t_1e_6:
        return t > 0 && t < N(1e6);
      case Fault::greatest_t_1e_15:
        return t > 0 && t < N(1e15);
      case Fault::negative_t:
      case Fault::absolute_t:
        return t == t;
      default:  // NOLINT: every other fault leaves this as it is
        return t > 0;
    }
  }

  template <class Shape>
  std::optional<N> first_of(const Shape& shape, const Line& line) const {
    if (is(Fault::small_numbers_vanish) && size_of(shape) < N(1e-20)) return std::nullopt;
    // 0/0 is a NaN, which every comparison takes for a miss.
    if (is(Fault::t_by_quotient_of_x) && line.v.x == 0) return std::nullopt;
    const Roots roots = roots_of(shape, line);
    const bool is_inside = roots[0] <= 0 && roots[1] > 0;
    if (is_inside && is(Fault::inside_is_a_miss)) return std::nullopt;
    if (is_inside && is(Fault::inside_is_at_origin)) return N(0);
    for (std::size_t i = is(Fault::near_root_skipped) && roots[1] == roots[1] ? 1 : 0; i < 2; ++i) {
      const N t = std::ldexp(roots[i], -line.places);
      if (is_ahead(t, size_of(shape)) && is_within(shape, line, roots[i]))
        return is(Fault::absolute_t) ? std::abs(t) : t;
      if (is(Fault::near_root_outside_clip_ends) && t > 0) return std::nullopt;
    }
    return std::nullopt;
  }

  template <class Shape>
  static N size_of(const Shape& shape) {
    if constexpr (requires { shape.altura; })
      return N(shape.altura);
    else if constexpr (requires { shape.radio; })
      return N(shape.radio);
    else
      return N(1);
  }

  // Spheres.

  Roots roots_of(const scene::Sphere& e, const Line& line) const {
    const N r = is(Fault::radius_squared_twice) ? N(e.radio) * N(e.radio) : N(e.radio);
    const V q = line.p - V(e.centro);
    const N a = is(Fault::unit_v_assumed) ? N(1) : glm::dot(line.v, line.v), b = glm::dot(q, line.v);
    if (is(Fault::unstable_quadratic)) return by_formula(a, b, glm::dot(q, q) - r * r);
    // From the middle of the chord: nothing large is subtracted.
    const N middle = -b / a;
    const V m = q + middle * line.v;
    if (is(Fault::limb_cut) && glm::length(m) > N(1 - 1e-4) * r) return {none, none};
    return about(middle, a, squared(r) - glm::dot(m, m), b);
  }

  N squared(N x) const {
    return is(Fault::squares_of_binary32) ? static_cast<N>(static_cast<float>(x) * static_cast<float>(x)) : x * x;
  }
  Roots by_formula(N a, N b, N c) const {
    const N root = std::sqrt(b * b - a * c);
    return {(-b - root) / a, (-b + root) / a};
  }
  Roots about(N middle, N a, N gap, N b) const {
    if (is(Fault::discriminant_by_epsilon) && gap < N(1e-4)) return {none, none};
    if (is(Fault::b_of_zero_is_a_miss) && b == 0) return {none, none};
    const N half = std::sqrt(gap / a);
    if (is(Fault::b_not_halved)) middle = 2 * middle;
    return {middle - half, middle + half};
  }
  bool is_within(const scene::Sphere&, const Line&, N) const { return true; }

  // Shapes with an axis: |q − s·d| = base − k·s, which is a cylinder where k is 0.

  struct Axis {
    V centro, d;
    N base, k, altura;
  };
  template <class Shape>
  Axis axis_of(const Shape& e) const {
    Axis axis{V(e.centro), V(e.vector), 0, 0, N(e.altura)};
    if constexpr (requires { e.proporcion; }) axis.k = N(e.proporcion);
    if (is(Fault::proportion_inverted) && axis.k != 0) axis.k = 1 / axis.k;
    axis.base = axis.k * axis.altura;
    if constexpr (requires { e.radio; })
      axis.base += is(Fault::radius_squared_twice) ? N(e.radio) * N(e.radio) : N(e.radio);
    if (is(Fault::radius_at_other_end)) axis.base -= axis.k * axis.altura, axis.k = -axis.k;
    if (is(Fault::axis_flipped)) axis.d = -axis.d;
    if (is(Fault::axis_is_z)) axis.d = V(0, 0, 1);
    if (is(Fault::altura_halved)) axis.altura /= 2;
    return axis;
  }

  /// A line against an axis: along it s0 + t·s1, across it m + t·n; from its point nearest to the axis, or to that
  /// within the ends, so that nothing large is subtracted; shift is where that is.
  struct Local {
    N shift, s0, s1;
    V m, n;
  };
  static Local local(const Axis& axis, const Line& line) {
    const V q = line.p - axis.centro;
    const N s = glm::dot(q, axis.d), s1 = glm::dot(line.v, axis.d);
    const V m = q - s * axis.d, n = line.v - s1 * axis.d;
    N shift = -glm::dot(m, n) / glm::dot(n, n);
    if (!std::isfinite(shift)) shift = 0;
    if (s1 != 0)
      shift = std::clamp(shift, std::min(-s / s1, (axis.altura - s) / s1), std::max(-s / s1, (axis.altura - s) / s1));
    return {shift, s + shift * s1, s1, m + shift * n, n};
  }

  template <class Shape>
    requires requires(Shape e) { e.altura; }
  Roots roots_of(const Shape& e, const Line& line) const {
    const Axis axis = axis_of(e);
    Local at = local(axis, line);
    if (is(Fault::sphere_too_small_around) && is_outside_ball(axis, line)) return {none, none};
    if (is(Fault::unstable_quadratic)) at = unshifted(axis, line);
    const N r0 = axis.base - axis.k * at.s0, r1 = -axis.k * at.s1;
    const N n2 = is(Fault::unit_v_assumed) ? 1 - at.s1 * at.s1 : glm::dot(at.n, at.n);
    const N a = n2 - squared(r1), b = glm::dot(at.m, at.n) - r0 * r1, c = glm::dot(at.m, at.m) - squared(r0);
    if (is(Fault::parallel_to_axis_by_epsilon) && n2 < N(1e-6)) return {none, none};
    if (is(Fault::linear_case_forgotten) && std::abs(a) < N(1e-9)) return {none, none};
    if (is(Fault::b_of_zero_is_a_miss) && glm::dot(line.p - axis.centro, at.n) == 0) return {none, none};
    Roots roots = quadratic(a, is(Fault::b_not_halved) ? 2 * b : b, c);
    if (is(Fault::unstable_quadratic)) return roots;
    for (N& t : roots) t = at.shift + refined(at, r0, r1, t);
    if (roots[1] < roots[0]) std::swap(roots[0], roots[1]);
    if (is(Fault::caps_added)) return with_caps(axis, line, roots);
    return roots;
  }
  static Local unshifted(const Axis& axis, const Line& line) {
    const V q = line.p - axis.centro;
    const N s = glm::dot(q, axis.d), s1 = glm::dot(line.v, axis.d);
    return {0, s, s1, q - s * axis.d, line.v - s1 * axis.d};
  }

  /// Each root by a sum of numbers of one sign.
  Roots quadratic(N a, N b, N c) const {
    N D = b * b - a * c;
    if (is(Fault::discriminant_by_epsilon) && D < N(1e-4)) return {none, none};
    const N root = std::sqrt(D);
    if (is(Fault::smaller_roots_by_difference) || is(Fault::unstable_quadratic))
      return {std::min((-b - root) / a, (-b + root) / a), std::max((-b - root) / a, (-b + root) / a)};
    const N sum = -(b + std::copysign(root, b));
    if (sum == 0) return a == 0 ? Roots{none, none} : Roots{N(0), N(0)};
    const N one = sum / a, other = c / sum;
    if (!std::isfinite(one)) return {other, none};
    return {std::min(one, other), std::max(one, other)};
  }

  /// Newton's steps on |m + t·n| − (r0 + t·r1), which is computed without squares.
  N refined(const Local& at, N r0, N r1, N t) const {
    if (is(Fault::smaller_roots_by_difference)) return t;
    for (int i = 0; i < 2; ++i) {
      const V w = at.m + t * at.n;
      const N length = glm::length(w), sign = r0 + t * r1 < 0 ? N(-1) : N(1);
      const N slope = glm::dot(w, at.n) / length - sign * r1, step = (length - sign * (r0 + t * r1)) / slope;
      if (!(std::abs(step) < N(0.001) * std::abs(length / glm::length(at.n)))) return t;
      t -= step;
    }
    return t;
  }

  N cut_of_ends() const {
    if (is(Fault::clip_narrowed)) return N(1e-4);
    if (is(Fault::ends_lengthened)) return N(-1e-4);
    return is(Fault::ends_cut) ? N(1e-3) : N(0);
  }
  template <class Shape>
    requires requires(Shape e) { e.altura; }
  bool is_within(const Shape& e, const Line& line, N t) const {
    const Axis axis = axis_of(e);
    const Local at = local(axis, line);
    const N s = is(Fault::clip_of_t) ? t : at.s0 + (t - at.shift) * at.s1;
    const N margin = cut_of_ends() * axis.altura;
    const N apex = is(Fault::apex_removed) ? N(1e-3) : is(Fault::apex_cut) ? N(1e-4) : N(0);
    if (apex > 0 && axis.base - axis.k * s < apex * axis.base) return false;
    if (is(Fault::clip_lower_end_missing)) return s <= axis.altura;
    if (is(Fault::clip_upper_end_missing)) return s >= 0;
    const N top = is(Fault::both_nappes) && axis.k != 0 ? 2 * axis.base / axis.k : axis.altura;
    return s >= margin && s <= top - margin;
  }
  bool is_outside_ball(const Axis& axis, const Line& line) const {
    const V q = line.p - (axis.centro + axis.altura / 2 * axis.d);
    const V m = q - glm::dot(q, line.v) / glm::dot(line.v, line.v) * line.v;
    return glm::dot(m, m) > squared(axis.altura / 2);
  }
  /// With the base where the line crosses it before.
  static Roots with_caps(const Axis& axis, const Line& line, const Roots& roots) {
    const N t = -glm::dot(line.p - axis.centro, axis.d) / glm::dot(line.v, axis.d);
    const V w = line.p + t * line.v - axis.centro;
    if (!(t > 0) || glm::dot(w, w) > axis.base * axis.base) return roots;
    return t < roots[0] || !(roots[0] > 0) ? Roots{t, roots[1]} : Roots{roots[0], t};
  }

  // Flat shapes.

  Roots across(const V& q, const V& normal, const Line& line, Fault by_epsilon) const {
    const N slope = glm::dot(line.v, normal);
    if (slope == 0 || (is(by_epsilon) && std::abs(slope) < N(1e-6))) return {none, none};
    return {-glm::dot(q, normal) / slope, none};
  }
  Roots roots_of(const scene::Plane& e, const Line& line) const {
    if (is(Fault::plane_one_sided) && glm::dot(line.v, V(e.vector)) > 0) return {none, none};
    return across(line.p - V(e.centro), V(e.vector), line, Fault::parallel_to_plane_by_epsilon);
  }
  bool is_within(const scene::Plane&, const Line&, N) const { return true; }

  Roots roots_of(const scene::Disc& e, const Line& line) const {
    if (is(Fault::discs_left_out)) return {none, none};
    return across(line.p - V(e.centro), V(e.vector), line, Fault::parallel_to_plane_by_epsilon);
  }
  N cut_of_disc() const {
    if (is(Fault::disc_small_1e_3)) return N(1e-3);
    if (is(Fault::disc_large)) return N(-1e-4);
    return is(Fault::disc_small_1e_4) ? N(1e-4) : N(0);
  }
  bool is_within(const scene::Disc& e, const Line& line, N t) const {
    const V m = line.p - V(e.centro) + t * line.v;
    const N r = is(Fault::radius_squared_twice) ? squared(N(e.radio)) : (1 - cut_of_disc()) * N(e.radio);
    if (is(Fault::disc_is_its_square)) return std::max({std::abs(m.x), std::abs(m.y), std::abs(m.z)}) <= r;
    return glm::dot(m, m) <= squared(r);
  }

  /// a·d − b·c with one rounding more than each product has: the error of one is added (Kahan).
  static N difference(N a, N d, N b, N c) {
    const N product = b * c, error = std::fma(b, c, -product);
    return std::fma(a, d, -product) - error;
  }
  V cross(const V& a, const V& b) const {
    if (is(Fault::normal_by_difference)) return glm::cross(a, b);
    return {difference(a.y, b.z, a.z, b.y), difference(a.z, b.x, a.x, b.z), difference(a.x, b.y, a.y, b.x)};
  }
  Roots roots_of(const scene::Triangle& e, const Line& line) const {
    const V a(e.vertices[0]), normal = cross(V(e.vertices[1]) - a, V(e.vertices[2]) - a);
    if (is(Fault::triangle_one_sided) && glm::dot(line.v, normal) > 0) return {none, none};
    return across(line.p - a, normal, line, Fault::determinant_by_epsilon);
  }
  N cut_of_triangle() const {
    if (is(Fault::triangle_edges_narrowed)) return N(1e-2);
    if (is(Fault::triangle_narrowed_1e_3)) return N(1e-3);
    if (is(Fault::triangle_widened)) return N(-1e-4);
    return is(Fault::triangle_narrowed_1e_4) ? N(1e-4) : N(0);
  }
  /// By the point where the line crosses the plane: by volumes of the line and the edges, every line in the plane
  /// would.
  bool is_within(const scene::Triangle& e, const Line& line, N t) const {
    const V a(e.vertices[0]), b(e.vertices[1]), c(e.vertices[2]), normal = cross(b - a, c - a);
    const N margin = cut_of_triangle() * glm::dot(normal, normal);
    const auto is_inside = [&](const V& from, const V& to) {
      const N beyond = glm::dot(line.p - from + t * line.v, glm::cross(normal, to - from));
      return is(Fault::triangle_without_edges) ? beyond > 0 : beyond >= margin;
    };
    return is_inside(a, b) && is_inside(b, c) && is_inside(c, a);
  }

  const scene::Scene& scene_;
  Fault fault_;
};

}  // namespace durero::test
