/// A cone in closed form: its quadratic along a ray, and its potencia in some hundred bits. The bounds are derived in
/// quadratic-inl.hpp and power-inl.hpp.

#if defined(DURERO_TRACE_SHAPE_CONE_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_SHAPE_CONE_INL_HPP_
#undef DURERO_TRACE_SHAPE_CONE_INL_HPP_
#else
#define DURERO_TRACE_SHAPE_CONE_INL_HPP_
#endif

#include "trace/power-inl.hpp"
#include "trace/quadratic-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

template <class T, class Cone, class Ray>
HWY_INLINE BoundedQuadratic<T> quadratic_of(Of<model::Tipo::soy_cono>, const Cone& cone, const Ray& ray) {
  BoundedQuadratic<T> f;
  const auto [q, a, b, Q] = axial<T>(cone, ray, f);
  const T k(cone.proporcion);
  set_errors(f, 1 + cone.proporcion * cone.proporcion, ray.speed, f.reach);
  const T g = T(cone.altura) - f.s0;
  set_factors(f, T(k * length(combination(g, a, f.s1, b))), length(cross(b, a)));
  const T k2 = k * k;
  f.A = dot(a, a) - k2 * (f.s1 * f.s1);
  f.B = dot(b, a) + k2 * (g * f.s1);
  f.C = dot(b, b) - k2 * (g * g);
  return f;
}

template <class R, class Cone>
HWY_INLINE Power<R> power_of(Of<model::Tipo::soy_cono>, const Cone& cone, const Place3<R>& q) {
  const R M = q.W + cone.altura, k = cone.proporcion;
  const Pair<R> s = avance(q, cone.vector);
  const Pair<R> radius = product(difference(Pair<R>(cone.altura), s), k);
  return {difference(alejamiento(q, s, cone.vector), square(radius)), power_error * (1 + k * k) * M * M};
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
