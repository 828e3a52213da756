/// The closed forms of every shape: dispatch from an element to its overload in shape/.

#if defined(DURERO_TRACE_SHAPES_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_SHAPES_INL_HPP_
#undef DURERO_TRACE_SHAPES_INL_HPP_
#else
#define DURERO_TRACE_SHAPES_INL_HPP_
#endif

#include "trace/shape/cone-inl.hpp"
#include "trace/shape/cylinder-inl.hpp"
#include "trace/shape/disc-inl.hpp"
#include "trace/shape/plane-inl.hpp"
#include "trace/shape/sphere-inl.hpp"
#include "trace/shape/triangle-inl.hpp"
#include "trace/shape/truncated_cone-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

template <class T, class Element, class Ray>
HWY_INLINE BoundedQuadratic<T> quadratic(const Element& element, const Ray& ray) {
  return quadratic_of<T>(Of<Element::tipo>(), element, ray);
}

/// potencia at p + t·v.
template <class R, class Element, class Ray>
HWY_INLINE Power<R> power_at(R t, const Element& element, const Ray& ray) {
  if constexpr (Element::tipo == model::Tipo::soy_triangulo)
    return power_of<R>(Of<Element::tipo>(), element, place_at(t, ray, element.vertices[0]));
  else
    return power_of<R>(Of<Element::tipo>(), element, place_at(t, ray, element.centro));
}

/// The quadratic of a ray that starts on the element: potencia at t, less potencia at the origin.
template <class R>
HWY_INLINE Power<R> launched(const Power<R>& there, const Power<R>& here) {
  return {difference(there.value, here.value), there.error + 2 * here.error};
}

/// The quadratic at t: potencia, less potencia at the origin where the ray starts on the element.
template <class Element>
HWY_INLINE Power<double> quadratic_at(double t, const Element& element, const Ray& ray, bool on) {
  const Power<double> there = power_at(t, element, ray);
  return on ? launched(there, power_at(0.0, element, ray)) : there;
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
