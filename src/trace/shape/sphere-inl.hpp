/// A sphere in closed form: its quadratic along a ray, and its potencia in some hundred bits. The bounds are derived in
/// quadratic-inl.hpp and power-inl.hpp.

#if defined(DURERO_TRACE_SHAPE_SPHERE_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_SHAPE_SPHERE_INL_HPP_
#undef DURERO_TRACE_SHAPE_SPHERE_INL_HPP_
#else
#define DURERO_TRACE_SHAPE_SPHERE_INL_HPP_
#endif

#include "trace/power-inl.hpp"
#include "trace/quadratic-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

template <class T, class Sphere, class Ray>
HWY_INLINE BoundedQuadratic<T> quadratic_of(Of<model::Tipo::soy_esfera>, const Sphere& sphere, const Ray& ray) {
  using std::sqrt;
  BoundedQuadratic<T> f;
  const Vec<T> q = difference<T>(ray.p, sphere.centro);
  const Vec<T> v = vec<T>(ray.v);
  const T r(sphere.radio);
  set_errors(f, Bound<T>(1), ray.speed, extent(q) + sphere.radio);
  f.A = dot(v, v);
  set_factors(f, T(r * sqrt(f.A)), length(cross(q, v)));
  f.B = dot(q, v);
  f.C = dot(q, q) - r * r;
  return f;
}

template <class R, class Sphere>
HWY_INLINE Power<R> power_of(Of<model::Tipo::soy_esfera>, const Sphere& sphere, const Place3<R>& q) {
  const R M = q.W + sphere.radio;
  return {difference(squared_length(q), two_prod<R>(sphere.radio, sphere.radio)), power_error * M * M};
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
