/// A disc in closed form: the quadratic along a ray and the potencia of its plane, and the margin by which the line
/// crosses the plane within the disc. With the letters of quadratic-inl.hpp the crossing is at t = −s0/s1, and
///   margin = r|s1| − |s1·q − s0·v|
/// is |s1| times the distance by which the crossing lies within the rim, for any d.
///
/// Bounds. s0 errs by 4ε|q| and s1 by 3εV; s1·q errs by 4ε and s0·v by 5ε of V|q|, their difference by 11ε and its
/// length, of at most V|q|, by 15ε; r|s1| errs by 4εrV. With one more rounding the sum is less than 16ε(r + |q|)V, to
/// first order. Twice as much pays for the rest.

#if defined(DURERO_TRACE_SHAPE_DISC_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_SHAPE_DISC_INL_HPP_
#undef DURERO_TRACE_SHAPE_DISC_INL_HPP_
#else
#define DURERO_TRACE_SHAPE_DISC_INL_HPP_
#endif

#include "trace/shape/plane-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

template <class T, class Disc, class Ray>
HWY_INLINE BoundedQuadratic<T> quadratic_of(Of<model::Tipo::soy_disco>, const Disc& disc, const Ray& ray) {
  BoundedQuadratic<T> f = quadratic_of<T>(Of<model::Tipo::soy_plano>(), disc, ray);
  const Vec<T> q = difference<T>(ray.p, disc.centro);
  const T s1 = f.B + f.B, radius = T(disc.radio) * s1;
  const T out = length(combination(s1, q, T(-f.C), vec<T>(ray.v)));
  f.edged = true;
  f.margin = leading(T(choose(leading(s1) < 0, T(-radius), radius) - out));
  f.margin_error = 32 * Numbers<T>::roundoff * ray.speed * (extent(q) + disc.radio);
  return f;
}

template <class R, class Disc>
HWY_INLINE Power<R> power_of(Of<model::Tipo::soy_disco>, const Disc& disc, const Place3<R>& q) {
  return power_of<R>(Of<model::Tipo::soy_plano>(), disc, q);
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
