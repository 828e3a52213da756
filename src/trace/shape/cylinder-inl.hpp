/// A cylinder in closed form: its quadratic along a ray, and its potencia in some hundred bits. The bounds are derived
/// in quadratic-inl.hpp and power-inl.hpp.

#if defined(DURERO_TRACE_SHAPE_CYLINDER_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_SHAPE_CYLINDER_INL_HPP_
#undef DURERO_TRACE_SHAPE_CYLINDER_INL_HPP_
#else
#define DURERO_TRACE_SHAPE_CYLINDER_INL_HPP_
#endif

#include "trace/power-inl.hpp"
#include "trace/quadratic-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

template <class T, class Cylinder, class Ray>
HWY_INLINE BoundedQuadratic<T> quadratic_of(Of<model::Tipo::soy_cilindro>, const Cylinder& cylinder, const Ray& ray) {
  using std::sqrt;
  BoundedQuadratic<T> f;
  const auto [q, a, b, Q] = axial<T>(cylinder, ray, f);
  const T r(cylinder.radio);
  set_errors(f, Bound<T>(1), ray.speed, Q + cylinder.radio);
  f.A = dot(a, a);
  set_factors(f, T(r * sqrt(f.A)), length(cross(b, a)));
  f.B = dot(b, a);
  f.C = dot(b, b) - r * r;
  return f;
}

template <class R, class Cylinder>
HWY_INLINE Power<R> power_of(Of<model::Tipo::soy_cilindro>, const Cylinder& cylinder, const Place3<R>& q) {
  const R M = q.W + cylinder.radio;
  const Pair<R> away = alejamiento(q, avance(q, cylinder.vector), cylinder.vector);
  return {difference(away, two_prod<R>(cylinder.radio, cylinder.radio)), power_error * M * M};
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
