/// The number types of the closed forms: T = double, Lanes and DoubleDouble, each with its unit roundoff, its leading
/// part and the difference of two binary64; and vectors over T.

#if defined(DURERO_TRACE_NUMBERS_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_NUMBERS_INL_HPP_
#undef DURERO_TRACE_NUMBERS_INL_HPP_
#else
#define DURERO_TRACE_NUMBERS_INL_HPP_
#endif

#include <cmath>

#include "trace/double_double-inl.hpp"
#include "trace/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

template <class T>
struct Numbers;

/// binary64, as a number or in lanes.
template <class R>
struct Binary64 {
  using Bound = R;
  static constexpr double roundoff = 0x1p-53;
  static HWY_INLINE R leading(R a) { return a; }
  static HWY_INLINE R difference(R a, R b) { return a - b; }
};

template <>
struct Numbers<double> : Binary64<double> {};

template <>
struct Numbers<Lanes> : Binary64<Lanes> {};

template <>
struct Numbers<DoubleDouble> {
  using Bound = double;
  static constexpr double roundoff = 0x1p-102;
  static HWY_INLINE double leading(const DoubleDouble& a) { return a.hi; }
  static HWY_INLINE DoubleDouble difference(double a, double b) { return two_sum(a, -b); }
};

/// The type of a bound on a T, and of T's leading part: binary64, as a number or in lanes.
template <class T>
using Bound = typename Numbers<T>::Bound;

/// The type of a condition on a T.
template <class T>
using Truth = decltype(Bound<T>() < Bound<T>());

template <class T>
HWY_INLINE Bound<T> leading(const T& a) {
  return Numbers<T>::leading(a);
}
template <class T>
HWY_INLINE Bound<T> magnitude(const T& a) {
  using std::abs;
  return abs(leading(a));
}

template <class T>
struct Vec {
  T x, y, z;
};

template <class T>
HWY_INLINE T dot(const Vec<T>& a, const Vec<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
HWY_INLINE Vec<T> cross(const Vec<T>& a, const Vec<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// a·x + b·y
template <class T>
HWY_INLINE Vec<T> combination(const T& a, const Vec<T>& x, const T& b, const Vec<T>& y) {
  return {a * x.x + b * y.x, a * x.y + b * y.y, a * x.z + b * y.z};
}
/// x − s·d
template <class T>
HWY_INLINE Vec<T> across(const Vec<T>& x, const T& s, const Vec<T>& d) {
  return {x.x - s * d.x, x.y - s * d.y, x.z - s * d.z};
}
template <class T>
HWY_INLINE T length(const Vec<T>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// The sum of the components' magnitudes, at least the Euclidean length.
template <class T>
HWY_INLINE Bound<T> extent(const Vec<T>& a) {
  return magnitude(a.x) + magnitude(a.y) + magnitude(a.z);
}

/// a − b and a, for stored vectors, in the numbers of T.
template <class T, class Stored>
HWY_INLINE Vec<T> difference(const Stored& a, const Stored& b) {
  using N = Numbers<T>;
  return {N::difference(a.x, b.x), N::difference(a.y, b.y), N::difference(a.z, b.z)};
}
template <class T, class Stored>
HWY_INLINE Vec<T> vec(const Stored& a) {
  return {T(a.x), T(a.y), T(a.z)};
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
