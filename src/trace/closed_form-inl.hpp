/// The first point of a ray on one element, by closed forms in a number type T of unit roundoff ε, with a certificate:
/// binary64 (triage) or double-double (stable). A hit or miss is said only where an error bound proves it. The
/// quadratic and the bounds of its coefficients are those of quadratic-inl.hpp.
///
/// The bounds here pass on those of the coefficients. Where operands err by all of their bounds, an error takes all of
/// its own, and that of the root of D a third (tests/trace/closed_form_test.cpp). On generic rays it takes far less,
/// because the coefficients err by far less than their bounds.

#if defined(DURERO_TRACE_CLOSED_FORM_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_CLOSED_FORM_INL_HPP_
#undef DURERO_TRACE_CLOSED_FORM_INL_HPP_
#else
#define DURERO_TRACE_CLOSED_FORM_INL_HPP_
#endif

#include <cmath>

#include "trace/shapes-inl.hpp"
#include "trace/steps.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

/// An approximation, within `error` of the exact number.
template <class T>
struct Approximation {
  T value;
  Bound<T> error;
};

/// √D. Precondition: B_error < F, which F ≤ H. |F·H − D| ≤ error·(|F| + H) + error² ≤ 3·error·H, as error < F ≤ H; and
/// |S − √D| = |S² − D|/(S + √D).
template <class T>
HWY_INLINE Approximation<T> root_of_discriminant(const BoundedQuadratic<T>& f) {
  using std::sqrt;
  const T S = sqrt(f.F * f.H);
  return {S, 3 * f.B_error * leading(f.H) / leading(S) + 4 * Numbers<T>::roundoff * leading(S)};
}

/// A root of the quadratic, within `error` of t.
template <class T>
struct Root {
  T t;
  Bound<T> error;
};

/// Whether the root certainly lies beyond the limit. The difference is rounded once, so its sign is right; with an
/// infinite limit it is −∞ or NaN, and the answer false.
template <class T>
HWY_INLINE Truth<T> beyond(const Root<T>& root, Bound<T> limit) {
  return leading(T(root.t - T(limit))) > root.error;
}

/// Whether a root certainly is, or certainly is not, a point of the ray and of the element; both are false where
/// neither is known.
template <class T>
struct RootMembership {
  Truth<T> outside, inside;
};

/// avance at the root. Its error has three parts: of s0 and s1, 4ε|q| + 3ε(|t| + error)V; of the root, |s1|·error; and
/// of the roundings of t·s1, of the sum and, where the caller takes it, of altura − avance, with which the first part
/// becomes 6ε|q| + 6ε(|t| + error)V + ε·altura. In all it is less than 16ε(|q| + altura + (|t| + error)V) + |s1|·error.
constexpr double advance_units = 16;
template <class T>
HWY_INLINE Approximation<T> advance(const BoundedQuadratic<T>& f, const Root<T>& root) {
  return {f.s0 + root.t * f.s1,
          advance_units * Numbers<T>::roundoff * (f.reach + (magnitude(root.t) + root.error) * f.speed) +
              (magnitude(f.s1) * 1.0000001) * root.error};
}

/// The place of a root: inside where t > 0, and 0 ≤ avance ≤ altura or margin ≥ 0 where the element is clipped.
template <class T>
HWY_INLINE RootMembership<T> place(const BoundedQuadratic<T>& f, const Root<T>& root) {
  const Bound<T> t = leading(root.t);
  const RootMembership<T> on_ray{(t < -root.error), (t > root.error)};
  if (f.edged) {
    const Truth<T> outside = on_ray.outside | (f.margin < -f.margin_error);
    const Truth<T> inside = on_ray.inside & (f.margin > f.margin_error);
    return {outside, inside};
  }
  if (!f.bounded) return on_ray;
  const Approximation<T> s = advance(f, root);
  const Bound<T> below = leading(s.value), above = leading(T(T(f.altura) - s.value));
  const Truth<T> outside = on_ray.outside | (below < -s.error) | (above < -s.error);
  const Truth<T> inside = on_ray.inside & (below > s.error) & (above > s.error);
  return {outside, inside};
}

/// A step's finding on the first point, in the step's own numbers.
template <class T>
struct FirstRoot {
  Decision verdict;
  Root<T> root{};
  Bound<T> slope{}, slope_error{};  ///< A·t + B, and the bound on its error
  Bound<T> A{}, A_error{};
};

template <class T>
HWY_INLINE FirstRoot<T> found_at(const BoundedQuadratic<T>& f, const Root<T>& root, const T& slope,
                                 Bound<T> slope_error) {
  return {Decision::hit, root, leading(slope), slope_error, leading(f.A), f.A_error};
}

/// x/y, both known to their errors: |x/y − x̂/ŷ| ≤ (x_error + |x̂/ŷ|·y_error)/(|ŷ| − y_error), and a rounding. Three
/// more roundings allow a caller to add the error to the result and round the sum (ends.hpp). Precondition: |ŷ| >
/// 2·y_error.
constexpr double quotient_units = 4;
template <class T>
HWY_INLINE Root<T> quotient(const T& x, Bound<T> x_error, const T& y, Bound<T> y_error) {
  const T t = x / y;
  const Bound<T> size = magnitude(t);
  const Bound<T> error = (x_error + size * y_error) / (magnitude(y) - y_error);
  return {t, error * 1.0000001 + quotient_units * Numbers<T>::roundoff * size};
}

/// The stable form of the two roots. With q = −(B + σS) and σ the sign of the computed B, the roots are q/A and C/q for
/// either sign, and A·t + B there −σS and σS. Where σ and A agree in sign, q/A is the smaller root.
template <class T>
struct Stable {
  Truth<T> positive;  ///< σ
  T S;                ///< σS
  Approximation<T> q;
};
template <class T>
HWY_INLINE Stable<T> stable_sum(const BoundedQuadratic<T>& f, const Approximation<T>& root) {
  const Truth<T> positive = leading(f.B) >= 0;
  const T S = choose(positive, root.value, T(-root.value));
  const T q = -(f.B + S);
  return {positive, S, {q, f.B_error + root.error + 2 * Numbers<T>::roundoff * magnitude(q)}};
}

/// The first of the two roots that is a point of the element, tried in ascending order. Precondition: the discriminant
/// is positive.
template <class T>
HWY_INLINE FirstRoot<T> first_of(const BoundedQuadratic<T>& f, Bound<T> limit) {
  using std::abs;
  const Approximation<T> root_of_D = root_of_discriminant(f);
  const auto [positive, S, q] = stable_sum(f, root_of_D);
  const Bound<T> size = magnitude(q.value), A = leading(f.A);
  if (!(size > 2 * q.error)) return {Decision::undecided};

  const bool A_known(abs(A) > 2 * f.A_error);
  // The bound `least` of |q/A| from below serves while A may be 0; it may exceed the element or the limit already.
  bool far_away = false;
  if (!A_known) {
    const Bound<T> least = 0.9999999 * (size - q.error) / (abs(A) + f.A_error);
    const Bound<T> rate = magnitude(f.s1) - 4 * Numbers<T>::roundoff * f.speed;
    far_away = least > limit || (f.bounded && least * rate > 2 * f.reach);
    if (!far_away) return {Decision::undecided};
  }
  const bool A_root_first((A > 0) == positive);
  for (int turn = 0; turn < 2; ++turn) {
    const bool A_root = (turn == 0) == A_root_first;
    if (A_root && far_away) continue;
    const Root<T> root =
        A_root ? quotient(q.value, q.error, f.A, f.A_error) : quotient(f.C, f.C_error, q.value, q.error);
    if (beyond(root, limit)) return {Decision::miss};
    const RootMembership<T> where = place(f, root);
    if (where.inside) return found_at(f, root, A_root ? T(-S) : S, root_of_D.error);
    if (!where.outside) return {Decision::undecided};
  }
  return {Decision::miss};
}

/// The first point of a ray that starts on the element. C = 0, so the roots are 0, which is no point of the ray, and
/// −2B/A.
template <class T>
HWY_INLINE FirstRoot<T> first_from_surface(const BoundedQuadratic<T>& f, Bound<T> limit) {
  if (!(magnitude(f.A) > 2 * f.A_error)) return {Decision::undecided};
  const Root<T> root = quotient(T(-(f.B + f.B)), 2 * f.B_error, f.A, f.A_error);
  if (beyond(root, limit)) return {Decision::miss};
  const RootMembership<T> where = place(f, root);
  if (where.inside) return found_at(f, root, T(-f.B), f.B_error);
  return {where.outside ? Decision::miss : Decision::undecided};
}

/// The root where A = 0: the quadratic is 2B·t + C, and its slope there B. Precondition: |B| > 2·B_error.
template <class T>
HWY_INLINE Root<T> root_of_linear(const BoundedQuadratic<T>& f) {
  return quotient(T(-f.C), f.C_error, T(f.B + f.B), 2 * f.B_error);
}

/// The first point where A = 0. Where B may be 0 too the ray may lie in the surface, which T cannot tell. Where the ray
/// starts on the element C = 0, so the only root is 0.
template <class T>
HWY_INLINE FirstRoot<T> first_of_linear(const BoundedQuadratic<T>& f, bool on, Bound<T> limit) {
  if (!(magnitude(f.B) > 2 * f.B_error)) return {Decision::undecided};
  if (on) return {Decision::miss};
  const Root<T> root = root_of_linear(f);
  if (beyond(root, limit)) return {Decision::miss};
  const RootMembership<T> where = place(f, root);
  if (where.inside) return found_at(f, root, f.B, f.B_error);
  return {where.outside ? Decision::miss : Decision::undecided};
}

/// The first point on a shape whose A is not 0 for every ray. `on`: the ray starts on the element.
template <class T>
HWY_INLINE FirstRoot<T> first_of_curved(const BoundedQuadratic<T>& f, bool on, Bound<T> limit) {
  if (on) return first_from_surface(f, limit);
  if (leading(f.F) < -f.B_error) return {Decision::miss};
  if (!(leading(f.F) > f.B_error)) return {Decision::undecided};
  return first_of(f, limit);
}

/// The first point of the ray on the element; or none (none up to the limit); or that T cannot tell. `on`: the ray
/// starts on the element. Precondition: element and ray are ordinary.
template <class T, class Element>
HWY_INLINE FirstRoot<T> closed_form(const Element& element, const Ray& ray, bool on, double limit) {
  const BoundedQuadratic<T> f = quadratic<T>(element, ray);
  if constexpr (is_linear(Element::tipo)) return first_of_linear<T>(f, on, limit);
  return first_of_curved<T>(f, on, limit);
}

/// The finding of a step. The slope is kept for the triage's root alone; in double-double its leading part would differ
/// from it by far more than its error.
template <class T>
HWY_INLINE RootEstimate published(const FirstRoot<T>& found) {
  const auto& [t, error] = found.root;
  if constexpr (requires { t.lo; }) {
    return {found.verdict, t.hi, t.lo, error};
  } else {
    return {found.verdict, t, 0, error, {found.slope, found.slope_error, found.A, found.A_error}};
  }
}

/// The first points in lanes, for rays that do not start on their elements, without a limit. Both roots are computed
/// always, and a lane where A may be 0 is undecided. L is Lanes, or the symbolic numbers that write proofs/Formas.v.
template <class L>
struct LanesFound {
  Truth<L> hit, undecided;
  Root<L> root;
  L slope, slope_error;
};
template <class L>
HWY_INLINE LanesFound<L> first_in_lanes(const BoundedQuadratic<L>& f) {
  const Truth<L> missed = f.F < -f.B_error;
  const Truth<L> met = f.F > f.B_error;
  const Approximation<L> root_of_D = root_of_discriminant(f);
  const auto [positive, S, q] = stable_sum(f, root_of_D);
  const Truth<L> known = met & (abs(q.value) > 2 * q.error) & (abs(f.A) > 2 * f.A_error);

  const Root<L> of_A = quotient(q.value, q.error, f.A, f.A_error);
  const Root<L> of_C = quotient(f.C, f.C_error, q.value, q.error);
  const Truth<L> A_root_first = (f.A > 0) == positive;
  const Root<L> near{choose(A_root_first, of_A.t, of_C.t), choose(A_root_first, of_A.error, of_C.error)};
  const Root<L> far{choose(A_root_first, of_C.t, of_A.t), choose(A_root_first, of_C.error, of_A.error)};
  const RootMembership<L> at_near = place(f, near), at_far = place(f, far);
  const Truth<L> far_one = at_near.outside & at_far.inside;

  const Truth<L> hit = known & (at_near.inside | far_one);
  const Truth<L> miss = missed | (known & at_near.outside & at_far.outside);
  return {hit,
          !(hit | miss),
          {choose(far_one, far.t, near.t), choose(far_one, far.error, near.error)},
          choose(A_root_first == far_one, S, -S),
          root_of_D.error};
}

/// The first points where there is one root, in the lanes where it is known.
template <class L>
HWY_INLINE LanesFound<L> only_root(const BoundedQuadratic<L>& f, Truth<L> known, const Root<L>& root, L slope) {
  const RootMembership<L> at = place(f, root);
  const Truth<L> hit = known & at.inside, miss = known & at.outside;
  return {hit, !(hit | miss), root, slope, f.B_error};
}

/// The first points in lanes where A = 0.
template <class L>
HWY_INLINE LanesFound<L> first_of_linear_in_lanes(const BoundedQuadratic<L>& f) {
  return only_root<L>(f, abs(f.B) > 2 * f.B_error, root_of_linear(f), f.B);
}

/// first_from_surface in lanes.
template <class L>
HWY_INLINE LanesFound<L> first_from_surface_in_lanes(const BoundedQuadratic<L>& f) {
  const Root<L> root = quotient(-(f.B + f.B), 2 * f.B_error, f.A, f.A_error);
  return only_root<L>(f, abs(f.A) > 2 * f.A_error, root, -f.B);
}

/// first_of_linear in lanes for rays that start on their elements: the only root is 0, which is no point of the ray.
template <class L>
HWY_INLINE LanesFound<L> first_of_linear_from_surface_in_lanes(const BoundedQuadratic<L>& f) {
  const Truth<L> known = abs(f.B) > 2 * f.B_error;
  return {known & !known, !known, {}, f.B, f.B_error};
}

/// The first points in lanes on elements of one type: for rays that do not start on them, and for rays that do.
template <model::Tipo tipo, class L>
HWY_INLINE LanesFound<L> found_in_lanes(const BoundedQuadratic<L>& f) {
  return is_linear(tipo) ? first_of_linear_in_lanes(f) : first_in_lanes(f);
}
template <model::Tipo tipo, class L>
HWY_INLINE LanesFound<L> found_in_lanes_from(const BoundedQuadratic<L>& f) {
  return is_linear(tipo) ? first_of_linear_from_surface_in_lanes(f) : first_from_surface_in_lanes(f);
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
