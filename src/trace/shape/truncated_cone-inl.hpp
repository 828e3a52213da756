/// A truncated cone in closed form: its quadratic along a ray, and its potencia in some hundred bits. With the letters
/// of quadratic-inl.hpp and the radius at the origin's advance ρ = r + k·g,
///   A = a·a − k²s1²    B = b·a + ρ·k·s1    C = b·b − ρ²    F, H = |ρ·a + k·s1·b| ∓ |b × a|,
/// for any d and D = F·H: with k = 0 the cylinder's, with r = 0 the cone's.
///
/// Bounds. With E ≥ |q| + altura + r, g errs by 5εE and |ρ| ≤ (1 + k)E, so ρ errs by (1 + 7k)εE, and k·s1 by 4εkV. As
/// k ≤ (1 + k²)/2 = κ/2, to first order
///   A:  25εV² as for the cone; (k·s1)²: 9εk²V²                                                in all ≤ 27εκV²
///   B:  22εVE; ρ·k·s1: (1 + 7k)kεVE + (1 + k)·4εkVE + (1 + k)kεVE = (6k + 12k²)εVE; the sum    in all ≤ 40εκVE
///   C:  25εE²; ρ²: 2(1 + k)(1 + 7k)εE² + (1 + k)²εE² = (3 + 18k + 15k²)εE²; the difference     in all ≤ 42εκE²
///   |ρ·a + k·s1·b|: (1 + 7k)·εVE + (1 + k)·8εVE + (1 + k)εVE; 4εkVE + 10εkVE + εkVE; the sum and its root 5(1 + 2k)εVE
///                                                                                             in all ≤ (15 + 41k)εVE
///   F, H: that, 25εVE for |b × a| and one more rounding of at most 2(1 + 2k)εVE                in all ≤ (42 + 45k)εVE
/// where (42 + 45k) ≤ 64(1 + k²) for every k: at k = 45/128, where the difference is least, it is 57.8 against 71.9.
/// The 64 units of the other shapes therefore suffice. (proofs/Conical.v counts 36 units for |b × a|, and keeps the
/// parts that h and r bring to ρ apart from |q|: for F and H it then needs 53.25εκVE.) In the power, with M = W +
/// altura + r, the lower parts of s are 10u·W, those of altura − s 11u·M and those of the radius there, which is at
/// most (1 + k)M, (1 + 13k)u·M: twice their product is at most 42u·κM². With the rest, 2·10u·M² and the remainders of
/// squares and sums, they stay below the 100u·κM² that power-inl.hpp counts.

#if defined(DURERO_TRACE_SHAPE_TRUNCATED_CONE_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_SHAPE_TRUNCATED_CONE_INL_HPP_
#undef DURERO_TRACE_SHAPE_TRUNCATED_CONE_INL_HPP_
#else
#define DURERO_TRACE_SHAPE_TRUNCATED_CONE_INL_HPP_
#endif

#include "trace/power-inl.hpp"
#include "trace/quadratic-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

template <class T, class TruncatedCone, class Ray>
HWY_INLINE BoundedQuadratic<T> quadratic_of(Of<model::Tipo::soy_tronco>, const TruncatedCone& cone, const Ray& ray) {
  BoundedQuadratic<T> f;
  const auto [q, a, b, Q] = axial<T>(cone, ray, f);
  const T k(cone.proporcion), r(cone.radio);
  set_errors(f, 1 + cone.proporcion * cone.proporcion, ray.speed, f.reach + cone.radio);
  const T rho = r + k * (T(cone.altura) - f.s0), slope = k * f.s1;
  set_factors(f, length(combination(rho, a, slope, b)), length(cross(b, a)));
  f.A = dot(a, a) - slope * slope;
  f.B = dot(b, a) + rho * slope;
  f.C = dot(b, b) - rho * rho;
  return f;
}

template <class R, class TruncatedCone>
HWY_INLINE Power<R> power_of(Of<model::Tipo::soy_tronco>, const TruncatedCone& cone, const Place3<R>& q) {
  const R M = q.W + cone.altura + cone.radio, k = cone.proporcion;
  const Pair<R> s = avance(q, cone.vector);
  const Pair<R> radius = sum(product(difference(Pair<R>(cone.altura), s), k), Pair<R>(cone.radio));
  return {difference(alejamiento(q, s, cone.vector), square(radius)), power_error * (1 + k * k) * M * M};
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
