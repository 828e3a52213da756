#pragma once
/// A program that casts balls by closed forms in long double, and the faults of such programs: spheres, planes and
/// triangles.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "durero/conform/ask/claim.hpp"
#include "durero/conform/families/suite.hpp"

namespace durero::test {

/// A fault of a program that casts balls.
enum class CastFault {
  none,
  forgets_edges,
  forgets_vertices,
  casts_a_ray,
  doubles_the_radius,
  answers_the_length,
  misses_what_is_in_touch,
  ignores_back_faces,
  edges_without_ends,
  first_in_the_list,
  contact_behind,
  vertices_without_radius,
  face_without_foot,
  sphere_without_radius,
  answers_where_it_leaves,
  stops_short,
  contact_at_the_middle,
  scales_the_radius_with_v,
  sphere_from_outside_alone,
  misses_beyond_a_thousand,
};
inline constexpr std::array<std::string_view, 20> cast_fault_words = {"none",
                                                                      "forgets edges",
                                                                      "forgets vertices",
                                                                      "casts a ray",
                                                                      "doubles the radius",
                                                                      "answers a length for t",
                                                                      "misses what is in touch",
                                                                      "ignores back faces",
                                                                      "edges without ends",
                                                                      "the first of the list",
                                                                      "a touch behind the origin",
                                                                      "vertices without a radius",
                                                                      "a face without a foot",
                                                                      "a sphere without the radius",
                                                                      "where it leaves",
                                                                      "stops short by 0.001",
                                                                      "the middle for the contact",
                                                                      "the radius times |v|",
                                                                      "a sphere from outside alone",
                                                                      "nothing beyond t = 1000"};

/// The vectors of the program.
struct Long3 {
  long double x = 0, y = 0, z = 0;
  Long3() = default;
  Long3(long double a, long double b, long double c) : x(a), y(b), z(c) {}
  explicit Long3(const glm::dvec3& v) : x(v.x), y(v.y), z(v.z) {}
  glm::dvec3 rounded() const { return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}; }
};
inline Long3 operator+(const Long3& a, const Long3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Long3 operator-(const Long3& a, const Long3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Long3 operator*(long double k, const Long3& a) { return {k * a.x, k * a.y, k * a.z}; }
inline long double dot(const Long3& a, const Long3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Long3 cross(const Long3& a, const Long3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline long double length(const Long3& a) { return std::sqrt(dot(a, a)); }

/// A stretch of t.
struct CastStretch {
  long double begin, end;
};

/// The t at which |q + t·w|² ≤ R²; across a line or a plane, q and w are what is left across.
inline std::optional<CastStretch> stretch_within(const Long3& q, const Long3& w, long double R) {
  const long double A = dot(w, w), B = dot(q, w), size = length(q);
  if (A == 0) return size <= R ? std::optional(CastStretch{-INFINITY, INFINITY}) : std::nullopt;
  const long double t = -B / A, beside = length(q + t * w);  // without the cancellation of B² − A·C
  if (beside > R) return std::nullopt;
  const long double half = std::sqrt((R - beside) * (R + beside) / A);
  return CastStretch{t - half, t + half};
}

/// A touch of the program.
struct FoundTouch {
  long double t;
  Long3 contact;
};

class Caster {
 public:
  Caster(const conform::SuiteCase& of, std::size_t ray, CastFault fault)
      : of_(&of),
        fault_(fault),
        p_(of.the_case.rays[ray].rayo.p().xyz()),
        v_(of.the_case.rays[ray].rayo.v().xyz()),
        R_(of.ranges[ray].radio) {
    if (has(CastFault::doubles_the_radius)) R_ *= 2;
    if (has(CastFault::casts_a_ray)) R_ *= 1e-6L;
    if (has(CastFault::scales_the_radius_with_v)) R_ *= length(v_);
  }

  conform::Claim claim() {
    std::optional<FoundTouch> first;
    std::optional<scene::ElementRef> element;
    of_->the_case.scene.for_each([&](scene::ElementRef e, const auto& shape) {
      found_.reset();
      touch(shape);
      if (!found_ || (first && (has(CastFault::first_in_the_list) || first->t <= found_->t))) return;
      first = found_;
      element = e;
    });
    const bool is_far = first && has(CastFault::misses_beyond_a_thousand) && first->t > 1000;
    if (!first || is_far) return {.outcome = conform::Claim::Outcome::miss};
    long double t = first->t;
    if (has(CastFault::answers_the_length)) t *= length(v_);
    if (has(CastFault::stops_short)) t *= 0.999L;
    const Long3 contact = has(CastFault::contact_at_the_middle) ? p_ + first->t * v_ : first->contact;
    return {.outcome = conform::Claim::Outcome::hit,
            .element = element,
            .t = static_cast<double>(t),
            .punto = contact.rounded()};
  }

 private:
  bool has(CastFault fault) const { return fault_ == fault; }

  void keep(long double t, const Long3& contact) {
    if (has(CastFault::misses_what_is_in_touch) && t == 0) return;
    if (!found_ || t < found_->t) found_ = {t, contact};
  }
  /// The t at which a stretch is entered, or 0 within it; nothing where it is behind.
  std::optional<long double> entered(const CastStretch& stretch) const {
    if (has(CastFault::answers_where_it_leaves)) return stretch.end >= 0 ? std::optional(stretch.end) : std::nullopt;
    if (has(CastFault::contact_behind) && stretch.end < 0) return -stretch.end;
    if (stretch.end < 0) return std::nullopt;
    return std::max(0.0L, stretch.begin);
  }

  void touch(const scene::Sphere& e) {
    const Long3 c(e.centro), q = p_ - c;
    const long double r = e.radio, R = has(CastFault::sphere_without_radius) ? 0 : R_;
    const auto on_surface = [&](long double t) {
      const Long3 x = q + t * v_;
      const long double size = length(x);
      keep(t, size > 0 ? c + (r / size) * x : c + Long3(r, 0, 0));
    };
    if (r > R && length(q) < r - R) {  // from inside
      if (has(CastFault::sphere_from_outside_alone)) return;
      if (const auto inner = stretch_within(q, v_, r - R)) on_surface(inner->end);
      return;
    }
    const auto outer = stretch_within(q, v_, r + R);
    if (!outer) return;
    if (const auto t = entered(*outer)) on_surface(*t);
  }

  void touch(const scene::Plane& e) {
    const Long3 d(e.vector), c(e.centro);
    const long double size = length(d), at = dot(p_ - c, d) / size, way = dot(v_, d) / size;
    const auto foot = [&](long double t) { keep(t, p_ + t * v_ - ((at + t * way) / size) * d); };
    if (has(CastFault::ignores_back_faces) && at < 0) return;
    if (std::abs(at) <= R_) return foot(0);
    if (at * way < 0) foot((std::abs(at) - R_) / std::abs(way));
  }

  void touch(const scene::Triangle& e) {
    const std::array<Long3, 3> corners = {Long3(e.vertices[0]), Long3(e.vertices[1]), Long3(e.vertices[2])};
    const Long3 n = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (has(CastFault::ignores_back_faces) && dot(v_, n) > 0) return;
    touch_face(corners, n);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!has(CastFault::forgets_edges)) touch_edge(corners[i], corners[(i + 1) % 3]);
      if (!has(CastFault::forgets_vertices)) touch_vertex(corners[i]);
    }
  }

  void touch_face(const std::array<Long3, 3>& corners, const Long3& n) {
    const long double size = length(n), at = dot(p_ - corners[0], n) / size, way = dot(v_, n) / size;
    if (std::abs(at) > R_ && at * way >= 0) return;
    const long double t = std::abs(at) <= R_ ? 0 : (std::abs(at) - R_) / std::abs(way);
    const Long3 foot = p_ + t * v_ - ((at + t * way) / size) * n;
    for (std::size_t i = 0; i < 3 && !has(CastFault::face_without_foot); ++i)
      if (dot(cross(corners[(i + 1) % 3] - corners[i], foot - corners[i]), n) < 0) return;
    keep(t, foot);
  }

  void touch_edge(const Long3& a, const Long3& b) {
    const Long3 way = b - a, q = p_ - a;
    const long double squared = dot(way, way);
    const auto across = [&](const Long3& w) { return w - (dot(w, way) / squared) * way; };
    const auto stretch = stretch_within(across(q), across(v_), R_);
    if (!stretch) return;
    const auto t = entered(*stretch);
    if (!t) return;
    const long double s = dot(q + *t * v_, way) / squared;
    if (has(CastFault::edges_without_ends) || (s >= 0 && s <= 1)) keep(*t, a + s * way);
  }

  void touch_vertex(const Long3& a) {
    const long double R = has(CastFault::vertices_without_radius) ? R_ * 1e-6L : R_;
    const auto stretch = stretch_within(p_ - a, v_, R);
    if (!stretch) return;
    if (const auto t = entered(*stretch)) keep(*t, a);
  }

  template <class Shape>
  void touch(const Shape&) {}

  const conform::SuiteCase* of_;
  CastFault fault_;
  Long3 p_, v_;
  long double R_;
  std::optional<FoundTouch> found_{};
};

}  // namespace durero::test
