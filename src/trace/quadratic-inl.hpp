/// The quadratic of a ray and an element over a number type T of unit roundoff ε, with a bound on the error of each
/// coefficient: the part that the shapes share. The quadratic of each shape is in shape/.
///
/// Quantities. With q = p − centro, s0 = q·d, s1 = v·d, a = v − s1·d, b = q − s0·d, g = altura − s0 (d = vector):
///   sphere    A = v·v            B = q·v            C = q·q − r²      F, H = r|v| ∓ |q × v|
///   cylinder  A = a·a            B = b·a            C = b·b − r²      F, H = r|a| ∓ |b × a|
///   cone      A = a·a − k²s1²    B = b·a + k²g·s1   C = b·b − k²g²    F, H = k|g·a + s1·b| ∓ |b × a|
/// for any d, unit or not, and D = B² − AC = F·H (Lagrange's identity): a difference of two distances, not of squares.
///
/// Bounds. Let V ≥ |v|; E ≥ |q| + r for sphere and cylinder, E ≥ |q| + altura for a cone; κ = 1, for a cone 1 + k².
/// Since |d|² is within 2⁻⁵⁰ of 1, no part across or along the axis exceeds its whole by more than that. To first order
/// in ε, adding for each operation its rounding and the errors of its operands:
///   q: ε|q|    s0: 4ε|q|    s1: 3εV    a: 8εV    b: 10ε|q|    g: 5εE
///   A:  2|a|·8εV + 4εV²                              and for k²s1²:  8εk²V²         in all ≤ 25εκV²
///   B:  |q|·8εV + V·10ε|q| + 4εV|q|                  and for k²g·s1: 14εk²VE        in all ≤ 25εκVE
///   C:  2|q|·10ε|q| + 5ε|q|² + 3εr²                  and for k²g²:   16εk²E²        in all ≤ 30εκE²
///   |b × a|: 8εV|q| + 10εV|q| + 3εV|q| + its own root 4εV|q|                        in all ≤ 25εVE
///   r|a|: r·8εV + 4εrV ≤ 12εVE;  k|g·a + s1·b|: k(8 + 5 + 10 + 3 + 4 + 4)εVE = 34εkVE + 2εkVE
///   F, H: the two above and one more rounding                                       in all ≤ (26 + 38k)εVE ≤ 40εκVE
/// as 38k + 26 ≤ 40(1 + k²) for every k. Every coefficient below is 64 in place of these, which more than pays for the
/// terms of second order and for the roundings of the bounds themselves (each below 2⁻⁴⁵ of a bound).
///
/// The 64 stay wide on purpose. Measured over every family (tests/conform/bounds_test.cpp) an error of binary64 takes
/// up to 1/27 of its bound on generic rays, and up to 1/8 on the worst rays that were found, because the bounds add up
/// roundings that all go one way, and measure lengths by the sum of their components. An error of double-double takes
/// up to 1/750 and 1/150, because its operations are taken to err by 16u², and mostly err by less than one. A narrower
/// bound would change no answer; it would only spare the next step some rays, and of four million ordinary rays none
/// needs that step (tests/bench, steps). These 64 are also the bounds that are proved (proofs/Flotante.v,
/// proofs/Cylinder.v, proofs/Conical.v) for the code of this header and of shape/ (proofs/Formas.v).
///
/// Range. Every number of the element and of the ray is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰ (`ordinary`), so no value
/// exceeds 2⁹⁰⁰ and none overflows. An operation that underflows adds at most 2⁻¹⁰⁷⁴, and later factors make that less
/// than 2⁻⁵⁰⁰; while V, E ≥ 2⁻¹⁰⁰ make the smallest bound, 64·2⁻¹⁰²·2⁻²⁰⁰, hundreds of binades more than that.

#if defined(DURERO_TRACE_QUADRATIC_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_QUADRATIC_INL_HPP_
#undef DURERO_TRACE_QUADRATIC_INL_HPP_
#else
#define DURERO_TRACE_QUADRATIC_INL_HPP_
#endif

#include <array>

#include "trace/numbers-inl.hpp"
#include "trace/steps.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

/// The quantities of the derivation above, with a bound on each error.
template <class T>
struct BoundedQuadratic {
  T A{}, B{}, C{};
  T F{}, H{};  ///< D = F·H; the error of both is at most B_error
  Bound<T> A_error{}, B_error{}, C_error{};
  T s0{}, s1{};          ///< avance at t is s0 + t·s1
  bool bounded = false;  ///< clipped along its axis: 0 ≤ avance ≤ altura
  Bound<T> altura{};
  Bound<T> reach{}, speed{};  ///< |q| + altura and V: the bounds of avance and of its rate
  bool edged = false;         ///< part of a plane; where margin ≥ 0 the line crosses it within the edge or on it
  Bound<T> margin{}, margin_error{};  ///< its leading part, whose sign is its own; the error of the whole
};

constexpr double coefficient_units = 64;

template <class T>
HWY_INLINE void set_errors(BoundedQuadratic<T>& f, Bound<T> kappa, Bound<T> V, Bound<T> E) {
  const Bound<T> unit = coefficient_units * Numbers<T>::roundoff * kappa;
  f.A_error = unit * V * V;
  f.B_error = unit * V * E;
  f.C_error = unit * E * E;
}

template <class T>
HWY_INLINE void set_factors(BoundedQuadratic<T>& f, const T& of_surface, const T& of_line) {
  f.F = of_surface - of_line;
  f.H = of_surface + of_line;
}

/// A tag that selects a shape's overload in shape/.
template <model::Tipo tipo>
using Of = std::integral_constant<model::Tipo, tipo>;

/// Whether the shape's potencia is linear, so that A = 0.
constexpr bool is_linear(model::Tipo tipo) {
  return tipo == model::Tipo::soy_plano || tipo == model::Tipo::soy_disco || tipo == model::Tipo::soy_triangulo;
}

/// Rays and elements of one type in lanes, with the letters of the scene's shapes. Attributes that the type lacks are
/// 0.
template <class L>
struct RayIn {
  Vec<L> p, v;
  L speed;
};
using LaneRay = RayIn<Lanes>;
template <model::Tipo of_all, class L = Lanes>
struct LaneElement {
  static constexpr model::Tipo tipo = of_all;
  Vec<L> centro;
  L radio, proporcion;
  Vec<L> vector;
  L altura;
  std::array<Vec<L>, 3> vertices;
};

/// The quantities that shapes along an axis share.
template <class T>
struct Axial {
  Vec<T> q, a, b;
  Bound<T> Q;
};
template <class T, class Element, class Ray>
HWY_INLINE Axial<T> axial(const Element& element, const Ray& ray, BoundedQuadratic<T>& f) {
  const Vec<T> q = difference<T>(ray.p, element.centro);
  const Vec<T> v = vec<T>(ray.v), d = vec<T>(element.vector);
  f.s0 = dot(q, d);
  f.s1 = dot(v, d);
  f.bounded = true;
  f.altura = element.altura;
  f.speed = ray.speed;
  const Bound<T> Q = extent(q);
  f.reach = Q + element.altura;
  return {q, across(v, f.s1, d), across(q, f.s0, d), Q};
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
