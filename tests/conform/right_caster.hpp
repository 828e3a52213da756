#pragma once
/// Right programs that cast balls: their data are those of a question, rounded, or moved by no more than is declared,
/// and of these they find the first touch by halving, from distances to sixty digits. Nothing of the judge's code is
/// used.

#include <algorithm>
#include <optional>
#include <utility>

#include "right_nearest.hpp"

namespace durero::test {

/// A ball on its way.
struct CastBall {
  Digits3 p, v;
  Digits radius, speed;

  CastBall(const glm::dvec3& from, const glm::dvec3& way, double R)
      : p(from), v(way), radius(R), speed(length(Digits3(way))) {}
  Digits3 at(const Digits& t) const { return p + t * v; }
};

template <class Shape>
NearestPoint nearest_to_ball(const Shape& shape, const Digits3& x, bool by_text) {
  if constexpr (requires { shape.altura; })
    return by_text ? nearest_by_text(shape, x) : nearest_of_wall(shape, x);
  else
    return nearest_point(shape, x);
}

/// The first t of low … high at which `apart`, which changes by `speed` at most, is 0 or less, up to `fine`. Nothing
/// where there is none; `turns` counts the places that may be looked at still.
template <class Apart>
std::optional<Digits> first_zero(const Apart& apart, const Digits& low, const Digits& high, const Digits& speed,
                                 const Digits& fine, int& turns) {
  const Digits half = (high - low) / 2, middle = low + half;
  if (--turns < 0 || apart(middle) > speed * half) return std::nullopt;
  if (half * speed < fine) return low;
  if (auto before = first_zero(apart, low, middle, speed, fine, turns)) return before;
  return first_zero(apart, middle, high, speed, fine, turns);
}

/// The first touch of a shape, and of what; nothing where there is none. `is_lost` says that it was not found.
struct CastTouch {
  Digits t;
  NearestPoint contact;
};
template <class Shape>
std::optional<CastTouch> touch_of(const Shape& shape, const CastBall& ball, bool by_text, double M, bool& is_lost) {
  const auto apart = [&](const Digits& t) {
    return nearest_to_ball(shape, ball.at(t), by_text).distance - ball.radius;
  };
  const auto touch = [&](const Digits& t) {
    return std::optional(CastTouch{t, nearest_to_ball(shape, ball.at(t), by_text)});
  };
  if (apart(0) <= 0) return touch(0);
  Digits end = (4 * Digits(M) + 2 * ball.radius) / ball.speed;  // beyond it the ball has passed each bounded shape
  if constexpr (std::is_same_v<Shape, scene::Plane>) {
    const Digits towards = dot(ball.v, Digits3(shape.vector)), size = length(Digits3(shape.vector));
    const Digits at = dot(ball.p - Digits3(shape.centro), Digits3(shape.vector));
    if (at * towards >= 0) return std::nullopt;
    return touch((abs(at) - ball.radius * size) / abs(towards));
  }
  int turns = 3000;
  const std::optional<Digits> t = first_zero(apart, Digits(0), end, ball.speed, Digits(M) * Digits(1e-24), turns);
  is_lost = is_lost || turns < 0;
  return t ? touch(*t) : std::nullopt;
}

/// A program that casts balls, and what it claims.
struct BallCaster {
  conform::Profile profile;
  Data data = Data::given;     ///< but for `ends`
  Draw draw = Draw::anywhere;  ///< of moved data
  bool by_text = false;        ///< takes axes as they are, in the place of v/|v|
  bool gives_t = true, gives_point = true;
  bool culls_backs = false;
};

/// The first touch of one question, by the data of one program.
class RightCast {
 public:
  RightCast(const BallCaster& caster, const conform::SuiteCase& of, std::size_t ray, conform::Random& random)
      : caster_(&caster),
        of_(&of),
        p_(of.the_case.rays[ray].rayo.p().xyz()),
        v_(of.the_case.rays[ray].rayo.v().xyz()),
        radius_(of.ranges[ray].radio),
        mover_(random, caster.profile.format, caster.draw, caster.profile.thickness, caster.profile.error) {}

  /// Nothing where a draw left no element, a number is none of the format, or a touch was not found.
  std::optional<conform::Claim> claim() {
    of_->the_case.scene.for_each([&](scene::ElementRef e, const auto& shape) { find(e, shape); });
    if (is_lost_) return std::nullopt;
    if (!first_) return conform::Claim{.outcome = conform::Claim::Outcome::miss};
    conform::Claim claim{.outcome = conform::Claim::Outcome::hit};
    if (caster_->profile.names_elements) claim.element = element_;
    if (caster_->gives_t && caster_->profile.measure != conform::Measure::point) claim.t = number_;
    const Digits3& q = first_->contact.point;
    if (caster_->gives_point)
      claim.punto = glm::dvec3(rounded(static_cast<double>(q.x)), rounded(static_cast<double>(q.y)),
                               rounded(static_cast<double>(q.z)));
    const bool is_finite = std::isfinite(number_) && std::isfinite(longest(claim.punto.value_or(p_)));
    return is_finite ? std::optional(claim) : std::nullopt;
  }

 private:
  template <class T>
  T rounded(const T& x) const {
    return narrowed(x, caster_->profile.format);
  }

  template <class Shape>
  void find(scene::ElementRef e, const Shape& shape) {
    if (caster_->data == Data::given) return take(e, shape, p_, v_, radius_);
    if (caster_->data == Data::rounded) return take(e, rounded(shape), rounded(p_), rounded(v_), rounded(radius_));
    // M has the way to the touch, which moved data may have a little earlier; data with one before are moved too far.
    const double least = std::max({longest(shape), longest(p_), radius_});
    const std::optional<CastTouch> given = touch_of(shape, CastBall(p_, v_, radius_), false, least, is_lost_);
    const double way = given ? 0.99 * static_cast<double>(given->t) * longest(v_) : 0;
    const double M = std::max(least, way);
    const scene::Sphere ball = mover_.moved(scene::Sphere{glm::dvec3(0), radius_}, M);
    const Shape moved = mover_.moved(shape, M);
    const glm::dvec3 p = mover_.moved_point(p_, M), v = mover_.moved_direction(v_);
    take(e, moved, p, v, ball.radio, given ? 0.99 * given->t : Digits(0));
  }

  bool is_solid_around(const scene::Sphere& shape, const glm::dvec3& p) const {
    return length(Digits3(p) - Digits3(shape.centro)) < shape.radio;
  }
  bool is_solid_around(const scene::Plane& shape, const glm::dvec3& p) const {
    return caster_->profile.half_spaces && dot(Digits3(p) - Digits3(shape.centro), Digits3(shape.vector)) < 0;
  }
  template <class Shape>
  bool is_solid_around(const Shape&, const glm::dvec3&) const {
    return false;
  }

  template <class Shape>
  bool is_culled(const Shape& shape, const glm::dvec3& p, const glm::dvec3& v) const {
    if (!caster_->culls_backs || caster_->profile.back_faces != conform::BackFaces::unseen) return false;
    if constexpr (requires { shape.vertices; }) {
      const Digits3 a(shape.vertices[0]), x = Digits3(shape.vertices[1]) - a, y = Digits3(shape.vertices[2]) - a;
      const Digits3 n{x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x};
      return dot(Digits3(v), n) >= 0 || dot(Digits3(p) - a, n) <= 0;
    } else if constexpr (
        !requires { shape.altura; } && requires { shape.vector; }) {
      const Digits3 n(shape.vector);
      return dot(Digits3(v), n) >= 0 || dot(Digits3(p) - Digits3(shape.centro), n) <= 0;
    } else {
      return false;
    }
  }

  template <class Shape>
  void take(scene::ElementRef e, const Shape& shape, const glm::dvec3& p, const glm::dvec3& v, double radius,
            const Digits& least = 0) {
    const bool is_usable = is_shape(shape) && std::isfinite(longest(p)) && std::isfinite(longest(v)) &&
                           longest(v) > 0 && std::isfinite(radius) && radius > 0;
    is_lost_ = is_lost_ || !is_usable;
    if (is_lost_ || is_culled(shape, p, v)) return;
    const conform::Inside inside = caster_->profile.inside;
    const bool is_around = is_solid_around(shape, p);
    if (is_around && inside == conform::Inside::nothing) return;
    const double M = std::max({longest(shape), longest(p), radius});
    std::optional<CastTouch> found = touch_of(shape, CastBall(p, v, radius), caster_->by_text, M, is_lost_);
    is_lost_ = is_lost_ || (found && found->t < least);
    if (is_around && inside == conform::Inside::origin) found = CastTouch{0, {Digits3(p), 0}};
    if (found) keep(e, *found, v);
  }

  void keep(scene::ElementRef e, const CastTouch& found, const glm::dvec3& v) {
    const bool is_length = caster_->profile.measure == conform::Measure::length;
    const double number = rounded(static_cast<double>(is_length ? found.t * length(Digits3(v)) : found.t));
    const bool is_beyond = number < rounded(caster_->profile.least_t) || number > rounded(caster_->profile.greatest_t);
    if (is_beyond || (first_ && first_->t <= found.t)) return;
    first_ = found;
    element_ = e;
    number_ = number;
  }

  const BallCaster* caster_;
  const conform::SuiteCase* of_;
  glm::dvec3 p_, v_;
  double radius_;
  Mover mover_;
  bool is_lost_ = false;
  std::optional<CastTouch> first_{};
  scene::ElementRef element_{};
  double number_ = 0;
};

}  // namespace durero::test
