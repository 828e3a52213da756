/// Improves a root by one step of Newton's, and rounds numbers once where that is certain, for one ray or several in
/// lanes. A certain result is rounded right: proofs/Once.v.

#if defined(DURERO_TRACE_ROUNDING_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_ROUNDING_INL_HPP_
#undef DURERO_TRACE_ROUNDING_INL_HPP_
#else
#define DURERO_TRACE_ROUNDING_INL_HPP_
#endif

#include <cmath>

#include "trace/closed_form-inl.hpp"
#include "trace/shapes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

/// quadratic_at for rays that start on their elements, one or several.
template <class R, class Element, class Ray>
HWY_INLINE Power<R> own_quadratic_at(R t, const Element& element, const Ray& ray) {
  return launched(power_at(t, element, ray), power_at(R(0.0), element, ray));
}

/// A root t = hi + lo within the error, where the slope is known not to be 0.
template <class R>
struct RefinedRoot {
  Truth<R> known;
  Pair<R> t;
  R error;
};

/// Newton's step. With δ = t* − t the way to the root t*, σ = A·t* + B and f the quadratic at t, f = −2σδ + Aδ². So δ =
/// −f/(2σ − Aδ), and |δ| ≤ t.error bounds the last term.
template <class R>
HWY_INLINE RefinedRoot<R> newton(const Root<R>& t, const Approximation<R>& slope, const Approximation<R>& A,
                                 const Power<R>& f) {
  using std::abs;
  const R denominator = 2 * slope.value;
  const R denominator_error = 1.0000001 * (2 * slope.error + (abs(A.value) + A.error) * t.error);
  const R value = f.value.hi + f.value.lo;
  const Root<R> delta = quotient(R(-value), f.error + 0x1p-52 * abs(value), denominator, denominator_error);
  return {abs(denominator) > 2 * denominator_error, two_sum(t.t, delta.t), delta.error};
}

/// A number rounded once, and whether that is certain.
template <class R>
struct RoundedNumber {
  R value;
  Truth<R> certain;
};

/// Rounds x once, certain where every number within the error of it rounds the same: rounding is monotone, and hi + (lo
/// ± error) is one rounded sum. The last term pays for the rounding of lo ± error. Numbers near the ends of the range
/// are left to the exact step.
template <class R>
HWY_INLINE RoundedNumber<R> round_once(const Pair<R>& x, R error) {
  using std::abs;
  const R wide = 1.0000001 * error + 0x1p-52 * abs(x.lo);
  const R low = x.hi + (x.lo - wide), high = x.hi + (x.lo + wide);
  const R size = abs(low);
  const Truth<R> certain = (low == high) & (size > 0x1p-900) & (size < 0x1p900);
  return {low, certain};
}

/// p + t·v, not rounded, and a bound on its error. The lower part consists of two remainders and t.lo·v, together at
/// most 3u(|p| + |t·v|), and passes through three roundings; the error of t, mostly the greater, is added.
template <class R>
struct Coordinate {
  Pair<R> value;
  R error;
};
template <class R>
HWY_INLINE Coordinate<R> coordinate(R p, R v, const Pair<R>& t, R t_error) {
  using std::abs;
  const Pair<R> way = product(t, v);
  return {sum(way, Pair<R>(p)), R(abs(v) * t_error + 0x1p-102 * (abs(way.hi) + abs(p)))};
}

/// The coordinate rounded once. Where v is 0 it is exactly p, with 0 for −0.
template <class R>
HWY_INLINE RoundedNumber<R> round_coordinate(R p, R v, const Pair<R>& t, R t_error) {
  const Coordinate<R> at = coordinate(p, v, t, t_error);
  const RoundedNumber<R> x = round_once(at.value, at.error);
  const Truth<R> still = v == 0, certain = still | x.certain;
  return {choose(still, R(p + 0.0), x.value), certain};
}

/// The coordinates of a point, each rounded once.
template <class R>
struct Coordinates {
  RoundedNumber<R> x, y, z;
};
template <class R, class Ray>
HWY_INLINE Coordinates<R> round_coordinates(const Ray& ray, const Pair<R>& t, R t_error) {
  const RoundedNumber<R> x = round_coordinate<R>(ray.p.x, ray.v.x, t, t_error);
  const RoundedNumber<R> y = round_coordinate<R>(ray.p.y, ray.v.y, t, t_error);
  const RoundedNumber<R> z = round_coordinate<R>(ray.p.z, ray.v.z, t, t_error);
  return {x, y, z};
}

/// The parameter and the point, each rounded once; certain where all of them are.
template <class R>
struct OncePoint {
  R t, x, y, z;
  Truth<R> certain;
};
template <class R>
HWY_INLINE OncePoint<R> joined(const RoundedNumber<R>& t, const Coordinates<R>& at) {
  const Truth<R> certain = t.certain & at.x.certain & at.y.certain & at.z.certain;
  return {t.value, at.x.value, at.y.value, at.z.value, certain};
}
template <class R, class Ray>
HWY_INLINE OncePoint<R> round_point(const Ray& ray, const Pair<R>& t, R t_error) {
  const RoundedNumber<R> of_t = round_once(t, t_error);
  return joined(of_t, round_coordinates<R>(ray, t, t_error));
}

/// A coordinate that all points of a flat element share, where its plane is perpendicular to that axis. For a plane or
/// disc it is the centre's, where the normal has no component along the other axes: of n·(x − c) = 0 remains n.x·(x −
/// c.x) = 0. For a triangle it is the corners', where these are equal. An interval around a computed coordinate could
/// not tell the sign of a floor at 0.
template <class R>
HWY_INLINE RoundedNumber<R> level_of_corners(R a, R b, R c) {
  const Truth<R> known = (a == b) & (a == c);
  return {a + 0.0, known};
}
template <class R>
HWY_INLINE RoundedNumber<R> level_of_centre(R c, R other, R another) {
  const Truth<R> known = (other == 0.0) & (another == 0.0);
  return {c + 0.0, known};
}
template <class R, class Element>
HWY_INLINE Coordinates<R> levels(const Element& element) {
  if constexpr (Element::tipo == model::Tipo::soy_triangulo) {
    const auto &a = element.vertices[0], &b = element.vertices[1], &c = element.vertices[2];
    return {level_of_corners<R>(a.x, b.x, c.x), level_of_corners<R>(a.y, b.y, c.y), level_of_corners<R>(a.z, b.z, c.z)};
  } else {
    const auto &c = element.centro, &n = element.vector;
    return {level_of_centre<R>(c.x, n.y, n.z), level_of_centre<R>(c.y, n.z, n.x), level_of_centre<R>(c.z, n.x, n.y)};
  }
}

/// The first number where it is certain, else the second.
template <class R>
HWY_INLINE RoundedNumber<R> either(const RoundedNumber<R>& first, const RoundedNumber<R>& second) {
  const Truth<R> certain = first.certain | second.certain;
  return {choose(first.certain, first.value, second.value), certain};
}

/// round_point for a ray that meets the element at t.
template <class R, class Element, class Ray>
HWY_INLINE OncePoint<R> round_point_on(const Element& element, const Ray& ray, const Pair<R>& t, R t_error) {
  if constexpr (!is_linear(Element::tipo)) {
    return round_point(ray, t, t_error);
  } else {
    const RoundedNumber<R> of_t = round_once(t, t_error);
    const Coordinates<R> at = round_coordinates<R>(ray, t, t_error), level = levels<R>(element);
    return joined(of_t, Coordinates<R>{either(level.x, at.x), either(level.y, at.y), either(level.z, at.z)});
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
