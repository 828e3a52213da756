/// Double-double numbers of about 106 bits: the unevaluated sum hi + lo of two binary64, with |lo| ≤ ulp(hi)/2. They
/// are compiled for every instruction set, since an exact product takes two operations with a fused multiply-add and
/// seventeen without; the results are the same bits.
///
/// Each operation below errs by at most 2⁻¹⁰² of its result, which is 16u² with u = 2⁻⁵³, as long as nothing overflows
/// or underflows (proofs/Sums.v, proofs/Products.v, proofs/Ratios.v). In units of u², relative to the result:
///   sum         3, since both halves are added exactly before anything is rounded (Joldes, Muller and Popescu, 2017);
///   product     9: the two mixed products and their sum lose 4, lo·lo added to them 2, the last sum 3;
///   quotient    13: the rest a − b·high is at most 3u·|a| and is known to 3u²·|a|; dividing its leading part by b's
///               leading part loses three roundings of it, 9; the last sum 1;
///   square root 6: Newton's step from a root with error 1.5u leaves 1.2, the rest's division 4, the last sum 1.

#if defined(DURERO_TRACE_DOUBLE_DOUBLE_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_DOUBLE_DOUBLE_INL_HPP_
#undef DURERO_TRACE_DOUBLE_DOUBLE_INL_HPP_
#else
#define DURERO_TRACE_DOUBLE_DOUBLE_INL_HPP_
#endif

#include <hwy/highway.h>

#include <cmath>
#include <type_traits>

#include "trace/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

/// hi + lo, as numbers or in lanes.
template <class R>
struct Twofold {
  R hi = 0;
  R lo = 0;

  Twofold() = default;
  HWY_INLINE Twofold(R value) : hi(value) {}
  HWY_INLINE Twofold(R high, R low) : hi(high), lo(low) {}
};
using DoubleDouble = Twofold<double>;

/// a + b, exactly.
template <class R>
HWY_INLINE Twofold<R> two_sum(R a, R b) {
  const R sum = a + b;
  const R of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// a + b, exactly. Precondition: |a| ≥ |b| or a = 0.
template <class R>
HWY_INLINE Twofold<R> fast_two_sum(R a, R b) {
  const R sum = a + b;
  return {sum, b - (sum - a)};
}

/// a as a sum of two numbers of 26 bits (Veltkamp). Precondition: |a| < 2⁹⁹⁵.
template <class R>
HWY_INLINE Twofold<R> split(R a) {
  const R shifted = R(0x1.0000002p27) * a;
  const R high = shifted - (shifted - a);
  return {high, a - high};
}

/// a·b, exactly (Dekker).
template <class R>
HWY_INLINE Twofold<R> two_prod_of_halves(R a, R b) {
  const R product = a * b;
  const Twofold<R> x = split(a), y = split(b);
  return {product, ((x.hi * y.hi - product) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
}

/// a·b − c, rounded once; only where the hardware has a fused multiply-add. No other code asks for one.
#if HWY_NATIVE_FMA
HWY_INLINE double fused_multiply_subtract(double a, double b, double c) { return __builtin_fma(a, b, -c); }
HWY_INLINE Lanes fused_multiply_subtract(Lanes a, Lanes b, Lanes c) { return hn::MulSub(a.v, b.v, c.v); }

/// a·b, exactly.
template <class R>
HWY_INLINE Twofold<R> two_prod(R a, R b) {
  const R product = a * b;
  return {product, fused_multiply_subtract(a, b, product)};
}
#else
/// a·b, exactly.
template <class R>
HWY_INLINE Twofold<R> two_prod(R a, R b) {
  return two_prod_of_halves(a, b);
}
#endif

template <class R>
HWY_INLINE Twofold<R> operator-(const Twofold<R>& a) {
  return {-a.hi, -a.lo};
}

template <class R>
HWY_INLINE Twofold<R> operator+(const Twofold<R>& a, const Twofold<R>& b) {
  const Twofold<R> high = two_sum(a.hi, b.hi), low = two_sum(a.lo, b.lo);
  const Twofold<R> sum = fast_two_sum(high.hi, high.lo + low.hi);
  return fast_two_sum(sum.hi, low.lo + sum.lo);
}
template <class R>
HWY_INLINE Twofold<R> operator-(const Twofold<R>& a, const Twofold<R>& b) {
  return a + -b;
}

template <class R>
HWY_INLINE Twofold<R> operator*(const Twofold<R>& a, const Twofold<R>& b) {
  const Twofold<R> high = two_prod(a.hi, b.hi);
  return fast_two_sum(high.hi, high.lo + (a.lo * b.lo + (a.hi * b.lo + a.lo * b.hi)));
}
template <class R>
HWY_INLINE Twofold<R> operator*(const Twofold<R>& a, std::type_identity_t<R> b) {
  const Twofold<R> high = two_prod(a.hi, b);
  return fast_two_sum(high.hi, high.lo + a.lo * b);
}

template <class R>
HWY_INLINE Twofold<R> operator/(const Twofold<R>& a, const Twofold<R>& b) {
  const R high = a.hi / b.hi;
  const Twofold<R> rest = a - b * high;
  return fast_two_sum(high, rest.hi / b.hi);
}

/// The square root. Precondition: a ≥ 0.
template <class R>
HWY_INLINE Twofold<R> sqrt(const Twofold<R>& a) {
  using std::sqrt;
  if (a.hi <= 0) return {};
  const R high = sqrt(a.hi);
  const Twofold<R> rest = a - two_prod(high, high);
  return fast_two_sum(high, rest.hi / (2 * high));
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
