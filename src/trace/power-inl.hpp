/// potencia at a point of a ray, in some hundred bits, for one element or several in lanes: the part that the shapes
/// share. The potencia of each shape is in shape/.
///
/// Numbers here are sums hi + lo of two binary64 that need not be normalised. Sums and products of leading parts are
/// split exactly into hi and a remainder; remainders are added up in binary64. With u = 2⁻⁵³ a remainder is a few u of
/// its hi, so its rounding is of the order of u².

#if defined(DURERO_TRACE_POWER_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_POWER_INL_HPP_
#undef DURERO_TRACE_POWER_INL_HPP_
#else
#define DURERO_TRACE_POWER_INL_HPP_
#endif

#include <cmath>

#include "trace/double_double-inl.hpp"
#include "trace/quadratic-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

/// hi + lo, not always normalised.
template <class R>
using Pair = Twofold<R>;

/// The square, by (hi + lo)² = hi² + (2hi + lo)·lo.
template <class R>
HWY_INLINE Pair<R> square(const Pair<R>& a) {
  const Pair<R> high = two_prod(a.hi, a.hi);
  return {high.hi, high.lo + (2 * a.hi + a.lo) * a.lo};
}

template <class R>
HWY_INLINE Pair<R> sum(const Pair<R>& a, const Pair<R>& b) {
  const Pair<R> high = two_sum(a.hi, b.hi);
  return {high.hi, high.lo + (a.lo + b.lo)};
}
template <class R>
HWY_INLINE Pair<R> difference(const Pair<R>& a, const Pair<R>& b) {
  return sum(a, Pair<R>(-b.hi, -b.lo));
}

template <class R>
HWY_INLINE Pair<R> product(const Pair<R>& a, R b) {
  const Pair<R> high = two_prod(a.hi, b);
  return {high.hi, high.lo + a.lo * b};
}

template <class R>
HWY_INLINE Pair<R> product(const Pair<R>& a, const Pair<R>& b) {
  const Pair<R> high = two_prod(a.hi, b.hi);
  return {high.hi, high.lo + (a.hi * b.lo + a.lo * b.hi)};
}

/// The point p + t·v relative to c along each axis, and W ≥ |p − c| + |t·v|.
template <class R>
struct Place3 {
  Pair<R> x, y, z;
  R W;
};

template <class R, class Ray, class Point>
HWY_INLINE Place3<R> place_at(R t, const Ray& ray, const Point& centro) {
  using std::abs;
  const Pair<R> a = two_sum<R>(ray.p.x, -centro.x), b = two_sum<R>(ray.p.y, -centro.y),
                c = two_sum<R>(ray.p.z, -centro.z);
  const R W = abs(a.hi) + abs(b.hi) + abs(c.hi) + abs(t) * ray.speed;
  return {sum(a, two_prod<R>(t, ray.v.x)), sum(b, two_prod<R>(t, ray.v.y)), sum(c, two_prod<R>(t, ray.v.z)), W};
}

template <class R>
HWY_INLINE Pair<R> squared_length(const Place3<R>& q) {
  return sum(sum(square(q.x), square(q.y)), square(q.z));
}

template <class R, class Axis>
HWY_INLINE Pair<R> avance(const Place3<R>& q, const Axis& d) {
  return sum(sum(product<R>(q.x, d.x), product<R>(q.y, d.y)), product<R>(q.z, d.z));
}

/// d·d − 1, at most 2⁻⁵⁰ in magnitude. The leading squares' sum less 1 is exact or nearly so, because the sum is close
/// to 1.
template <class R, class Axis>
HWY_INLINE R excess(const Axis& d) {
  const Pair<R> n = sum(sum(two_prod<R>(d.x, d.x), two_prod<R>(d.y, d.y)), two_prod<R>(d.z, d.z));
  return (n.hi - 1) + n.lo;
}

/// |q − s·d|² = |q|² − (2 − d·d)·s² = |q|² − s² + (d·d − 1)·s²
template <class R, class Axis>
HWY_INLINE Pair<R> alejamiento(const Place3<R>& q, const Pair<R>& s, const Axis& d) {
  const Pair<R> across = difference(squared_length(q), square(s));
  return {across.hi, across.lo + excess<R>(d) * (s.hi * s.hi)};
}

/// potencia at a point of the ray, and a bound on its error. In units of u·κ·M², M = W + r or W + altura: |q|'s lower
/// parts are at most 3u·W in all, those of s 10u·W, of altura − s 11u·M, and with the remainders of the squares and
/// sums all lower parts of the value come to less than 100. Each passes through at most 12 roundings: 1200u²·κM². At
/// most 2·(6 + 12·10)u²·κM² is lost where lower parts are rounded before a square. The sum is below 2⁻⁹⁵κM² =
/// 2048u²·κM², and the last subtraction's part for a ray that starts on the element is below another 2⁻⁹⁵κM². The bound
/// is proved: proofs/AtRoot.v, AtRootAxial.v and AtRootTriangle.v count at most 340u², and with that subtraction 421u²,
/// of sizes of at most 4.125κM². Measured errors (tests/conform/bounds_test.cpp) take up to 1/1600 of the bound on
/// generic rays and 1/110 on the worst found. The bound stays wide: the root that it improves is good to some forty
/// bits beyond a binary64 anyway, and a narrower bound could spare only the one rounding in 2⁴⁰ that lies between.
template <class R>
struct Power {
  Pair<R> value;
  R error;
};
constexpr double power_error = 0x1p-95;

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
