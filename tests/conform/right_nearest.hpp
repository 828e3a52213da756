#pragma once
/// Right programs that find nearest points: their data are those of a question, rounded, or moved by no more than is
/// declared, and of these they find the nearest points to sixty digits. Nothing of the judge's code is used, nor of
/// the exact distances.

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <optional>
#include <vector>

#include "durero/conform/ask/claim.hpp"
#include "durero/scene/any_shape.hpp"
#include "right_tracers.hpp"

namespace durero::test {

using Digits = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>, boost::multiprecision::et_off>;

struct Digits3 {
  Digits x{}, y{}, z{};
  Digits3() = default;
  Digits3(Digits a, Digits b, Digits c) : x(std::move(a)), y(std::move(b)), z(std::move(c)) {}
  explicit Digits3(const glm::dvec3& v) : x(v.x), y(v.y), z(v.z) {}
};
inline Digits3 operator+(const Digits3& a, const Digits3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Digits3 operator-(const Digits3& a, const Digits3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Digits3 operator*(const Digits& k, const Digits3& a) { return {k * a.x, k * a.y, k * a.z}; }
inline Digits dot(const Digits3& a, const Digits3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Digits length(const Digits3& a) { return sqrt(dot(a, a)); }
inline double largest_of(const Digits3& a) {
  return static_cast<double>(std::max({Digits(abs(a.x)), Digits(abs(a.y)), Digits(abs(a.z))}));
}

/// A point of a shape that is nearest to the one asked.
struct NearestPoint {
  Digits3 point;
  Digits distance;
};

inline NearestPoint at(const Digits3& point, const Digits3& p) { return {point, length(point - p)}; }
inline void keep_nearer(NearestPoint& kept, const NearestPoint& other) {
  if (other.distance < kept.distance) kept = other;
}

/// A point beside an axis of length 1: the advance, and the way from the axis.
struct BesideAxis {
  Digits3 d;
  Digits along;
  Digits3 out;
  Digits away;

  BesideAxis(const Digits3& centro, const Digits3& axis, const Digits3& p) : d((1 / length(axis)) * axis) {
    const Digits3 q = p - centro;
    along = dot(q, d);
    out = q - along * d;
    away = length(out);
    if (away > length(q) * Digits(1e-40)) {
      out = (1 / away) * out;
    } else {  // what is left are roundings, and any direction across the axis is as good
      away = 0;
      const Digits3 other = abs(d.x) < abs(d.y) ? Digits3(1, 0, 0) : Digits3(0, 1, 0);
      const Digits3 across = other - dot(other, d) * d;
      out = (1 / length(across)) * across;
    }
  }
};

inline NearestPoint nearest_point(const scene::Sphere& e, const Digits3& p) {
  const Digits3 c(e.centro), q = p - c;
  const Digits away = length(q);
  return at(away > 0 ? c + (e.radio / away) * q : c + Digits3(e.radio, 0, 0), p);
}
inline NearestPoint nearest_point(const scene::Plane& e, const Digits3& p) {
  const Digits3 d(e.vector);
  return at(p - (dot(p - Digits3(e.centro), d) / dot(d, d)) * d, p);
}
inline NearestPoint nearest_on_disc(const Digits3& centro, const Digits3& axis, const Digits& radio, const Digits3& p) {
  const BesideAxis seen(centro, axis, p);
  return at(centro + std::min(seen.away, radio) * seen.out, p);
}
inline NearestPoint nearest_point(const scene::Disc& e, const Digits3& p) {
  return nearest_on_disc(Digits3(e.centro), Digits3(e.vector), e.radio, p);
}

inline NearestPoint nearest_on_edge(const Digits3& a, const Digits3& b, const Digits3& p) {
  const Digits3 way = b - a;
  const Digits t = dot(p - a, way) / dot(way, way);
  return at(a + std::clamp(t, Digits(0), Digits(1)) * way, p);
}
inline NearestPoint nearest_point(const scene::Triangle& e, const Digits3& p) {
  const Digits3 a(e.vertices[0]), b(e.vertices[1]), c(e.vertices[2]), x = b - a, y = c - a, q = p - a;
  const Digits xx = dot(x, x), xy = dot(x, y), yy = dot(y, y), D = xx * yy - xy * xy;
  const Digits u = (dot(q, x) * yy - dot(q, y) * xy) / D, v = (dot(q, y) * xx - dot(q, x) * xy) / D;
  if (u >= 0 && v >= 0 && u + v <= 1) return at(a + u * x + v * y, p);
  NearestPoint nearest = nearest_on_edge(a, b, p);
  keep_nearer(nearest, nearest_on_edge(b, c, p));
  keep_nearer(nearest, nearest_on_edge(c, a, p));
  return nearest;
}

/// The radii of a shape with an axis at its centre and at its end.
template <class Shape>
std::pair<Digits, Digits> end_radii(const Shape& e) {
  Digits top = 0, narrowing = 0;
  if constexpr (requires { e.radio; }) top = e.radio;
  if constexpr (requires { e.proporcion; }) narrowing = Digits(e.proporcion) * e.altura;
  return {top + narrowing, top};
}

/// The nearest of the line from the radius at the centre to that at the end, of an axis of length 1.
template <class Shape>
NearestPoint nearest_of_wall(const Shape& e, const Digits3& p) {
  const Digits3 centro(e.centro);
  const BesideAxis seen(centro, Digits3(e.vector), p);
  const auto [base, top] = end_radii(e);
  const Digits slope = top - base, altura = e.altura;
  const Digits part = ((seen.away - base) * slope + seen.along * altura) / (slope * slope + altura * altura);
  const Digits t = std::clamp(part, Digits(0), Digits(1));
  return at(centro + t * altura * seen.d + (base + t * slope) * seen.out, p);
}

/// The nearest point by the words of the text, q·d = s and |q − s·d| = R(s), where d may be of another length: by a
/// search over s, first among some places and then between the neighbours of the best.
template <class Shape>
NearestPoint nearest_by_text(const Shape& e, const Digits3& p) {
  const Digits3 centro(e.centro), axis(e.vector);
  const Digits size = length(axis), slack = abs(1 - size * size) / size, altura = e.altura;
  const BesideAxis seen(centro, axis, p);
  const auto [base, top] = end_radii(e);
  const Digits slope = (top - base) / altura;
  const auto point = [&, base = base](const Digits& s) {
    const Digits R = base + slope * s, squared = R * R - slack * slack * s * s;
    return at(centro + (s / size) * seen.d + sqrt(std::max(Digits(0), squared)) * seen.out, p);
  };
  // Beyond the last ring, where R(s) = slack·s, there is none.
  const Digits end = slack > slope ? std::min(altura, Digits(base / (slack - slope))) : altura;
  std::vector<Digits> places{0, end};
  for (int i = 1; i < 24; ++i) places.push_back(end * i / 24);
  for (int i = 5; i < 60; i += 3) {
    places.push_back(ldexp(end, -i));
    places.push_back(end - ldexp(end, -i));
  }
  std::ranges::sort(places);
  std::size_t best = 0;
  NearestPoint nearest = point(places[0]);
  for (std::size_t i = 1; i < places.size(); ++i) {
    const NearestPoint here = point(places[i]);
    if (here.distance < nearest.distance) nearest = here, best = i;
  }
  Digits low = places[best > 0 ? best - 1 : 0], high = places[std::min(best + 1, places.size() - 1)];
  for (int turn = 0; turn < 100; ++turn) {
    const Digits one = low + (high - low) / 3, other = high - (high - low) / 3;
    const bool is_before = point(one).distance < point(other).distance;
    (is_before ? high : low) = is_before ? other : one;
  }
  keep_nearer(nearest, point((low + high) / 2));
  return nearest;
}

/// A program that finds nearest points, and what it claims.
struct NearestFinder {
  conform::Profile profile;
  Data data = Data::given;     ///< but for `ends`
  Draw draw = Draw::anywhere;  ///< of moved data
  bool by_text = false;        ///< takes axes as they are, in the place of v/|v|
  bool gives_distance = true, gives_point = true;
};

/// The nearest of one question, by the data of one program.
class RightNearest {
 public:
  RightNearest(const NearestFinder& finder, const conform::SuiteCase& of, std::size_t ray, conform::Random& random)
      : finder_(&finder),
        of_(&of),
        p_(of.the_case.rays[ray].rayo.p().xyz()),
        mover_(random, finder.profile.format, finder.draw, finder.profile.thickness, finder.profile.error) {}

  /// Nothing where a draw left no element, or a number is none of the format.
  std::optional<conform::Claim> claim() {
    of_->the_case.scene.for_each([&](scene::ElementRef e, const auto& shape) {
      if (is_whole_ && !is_left_out(e)) find(e, shape);
    });
    if (!is_whole_ || !nearest_) return std::nullopt;
    conform::Claim claim{.outcome = conform::Claim::Outcome::hit};
    if (finder_->profile.names_elements) claim.element = element_;
    if (finder_->gives_distance) claim.t = distance();
    const Digits3& q = nearest_->point;
    if (finder_->gives_point)
      claim.punto = glm::dvec3(rounded(static_cast<double>(q.x)), rounded(static_cast<double>(q.y)),
                               rounded(static_cast<double>(q.z)));
    const bool is_finite = std::isfinite(claim.t.value_or(0)) && std::isfinite(longest(claim.punto.value_or(p_)));
    return is_finite ? std::optional(claim) : std::nullopt;
  }
  /// The distance of claim(), in its format.
  double distance() const { return rounded(static_cast<double>(nearest_->distance)); }

 private:
  bool has_solids() const { return finder_->profile.caps == conform::Caps::solid; }
  bool is_left_out(scene::ElementRef e) const {
    return has_solids() && std::ranges::any_of(of_->solids, [&](const conform::Solid& solid) {
             return std::ranges::find(solid.discs, e) != solid.discs.end();
           });
  }
  bool is_wall(scene::ElementRef e) const {
    return has_solids() &&
           std::ranges::any_of(of_->solids, [&](const conform::Solid& solid) { return solid.wall == e; });
  }

  template <class T>
  T rounded(const T& x) const {
    return narrowed(x, finder_->profile.format);
  }

  template <class Shape>
  void find(scene::ElementRef e, const Shape& shape) {
    if (finder_->data == Data::given) return take(e, shape, p_);
    if (finder_->data == Data::rounded) return take(e, rounded(shape), rounded(p_));
    // M has the way to the nearest point, which the moved data may have a little nearer.
    const double way = 0.99 * largest_of(nearest_of(e, shape, Digits3(p_)).point - Digits3(p_));
    const double M = std::max({longest(shape), longest(p_), way});
    const Shape moved = mover_.moved(shape, M);
    take(e, moved, mover_.moved_point(p_, M));
  }

  template <class Shape>
  NearestPoint nearest_of(scene::ElementRef e, const Shape& shape, const Digits3& p) const {
    if constexpr (requires { shape.altura; }) {
      NearestPoint nearest = finder_->by_text ? nearest_by_text(shape, p) : nearest_of_wall(shape, p);
      if (!is_wall(e)) return nearest;
      const Digits3 centro(shape.centro), axis(shape.vector);
      const auto [base, top] = end_radii(shape);
      keep_nearer(nearest, nearest_on_disc(centro, axis, base, p));
      const Digits3 end = centro + (shape.altura / length(axis)) * axis;
      if (top > 0) keep_nearer(nearest, nearest_on_disc(end, axis, top, p));
      return nearest;
    } else {
      return nearest_point(shape, p);
    }
  }

  /// Whether the point lies in the solid that the element is.
  template <class Shape>
  bool is_inside(scene::ElementRef e, const Shape& shape, const Digits3& p) const {
    if constexpr (std::is_same_v<Shape, scene::Sphere>) {
      return length(p - Digits3(shape.centro)) < shape.radio;
    } else if constexpr (std::is_same_v<Shape, scene::Plane>) {
      return finder_->profile.half_spaces && dot(p - Digits3(shape.centro), Digits3(shape.vector)) < 0;
    } else if constexpr (requires { shape.altura; }) {
      const BesideAxis seen(Digits3(shape.centro), Digits3(shape.vector), p);
      const auto [base, top] = end_radii(shape);
      return is_wall(e) && seen.along > 0 && seen.along < shape.altura &&
             seen.away < base + (top - base) * (seen.along / shape.altura);
    } else {
      return false;
    }
  }

  template <class Shape>
  void take(scene::ElementRef e, const Shape& shape, const glm::dvec3& at_p) {
    is_whole_ = is_whole_ && is_shape(shape) && std::isfinite(longest(at_p));
    if (!is_whole_) return;
    const Digits3 p(at_p);
    const bool is_answered = finder_->profile.inside == conform::Inside::origin && is_inside(e, shape, p);
    const NearestPoint found = is_answered ? NearestPoint{p, 0} : nearest_of(e, shape, p);
    if (nearest_ && nearest_->distance <= found.distance) return;
    nearest_ = found;
    element_ = e;
  }

  const NearestFinder* finder_;
  const conform::SuiteCase* of_;
  glm::dvec3 p_;
  Mover mover_;
  bool is_whole_ = true;
  std::optional<NearestPoint> nearest_{};
  scene::ElementRef element_{};
};

}  // namespace durero::test
