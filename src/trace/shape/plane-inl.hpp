/// A plane in closed form: its quadratic along a ray, whose A is 0, and its potencia in some hundred bits. With the
/// letters of quadratic-inl.hpp,
///   A = 0    B = s1/2    C = s0, and F and H are not used.
///
/// Bounds. s0 errs by 4ε|q| and s1 by 3εV, to first order; twice as much pays for the rest. The lower parts of the
/// power are at most 3u·W in the coordinates and 10u·W in all, each through at most 12 roundings: 120u²·W, of the
/// 2048u²·W that power_error allows.

#if defined(DURERO_TRACE_SHAPE_PLANE_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_SHAPE_PLANE_INL_HPP_
#undef DURERO_TRACE_SHAPE_PLANE_INL_HPP_
#else
#define DURERO_TRACE_SHAPE_PLANE_INL_HPP_
#endif

#include "trace/power-inl.hpp"
#include "trace/quadratic-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

template <class T, class Plane, class Ray>
HWY_INLINE BoundedQuadratic<T> quadratic_of(Of<model::Tipo::soy_plano>, const Plane& plane, const Ray& ray) {
  BoundedQuadratic<T> f;
  const Vec<T> q = difference<T>(ray.p, plane.centro), d = vec<T>(plane.vector);
  f.B = dot(vec<T>(ray.v), d) * T(0.5);
  f.C = dot(q, d);
  f.B_error = 3 * Numbers<T>::roundoff * ray.speed;
  f.C_error = 8 * Numbers<T>::roundoff * extent(q);
  return f;
}

template <class R, class Plane>
HWY_INLINE Power<R> power_of(Of<model::Tipo::soy_plano>, const Plane& plane, const Place3<R>& q) {
  return {avance(q, plane.vector), power_error * q.W};
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
