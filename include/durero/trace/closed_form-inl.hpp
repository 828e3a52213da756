/// The first point of a ray on one element, by closed forms in a number type T of unit roundoff ε, with a certificate:
/// binary64 (triage) or double-double (stable). It says hit or miss only where a bound on its error proves it.
///
/// Quantities. With q = p − centro, s0 = q·d, s1 = v·d, a = v − s1·d, b = q − s0·d, g = altura − s0 (d = vector):
///   sphere    A = v·v            B = q·v            C = q·q − r²      F, H = r|v| ∓ |q × v|
///   cylinder  A = a·a            B = b·a            C = b·b − r²      F, H = r|a| ∓ |b × a|
///   cone      A = a·a − k²s1²    B = b·a + k²g·s1   C = b·b − k²g²    F, H = k|g·a + s1·b| ∓ |b × a|
/// for any d, unit or not, and D = B² − AC = F·H (Lagrange's identity): a difference of two distances, not of squares.
///
/// Bounds. Let V ≥ |v|; E ≥ |q| + r for sphere and cylinder, E ≥ |q| + altura for a cone; κ = 1, for a cone 1 + k².
/// As |d|² is within 2⁻⁵⁰ of 1, no part across or along the axis exceeds its whole by more than that. To first order
/// in ε, adding for each operation its rounding and what its operands bring:
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
/// Range. Every number of the element and of the ray is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰ (`ordinary`), so no value
/// exceeds 2⁹⁰⁰ and none overflows. An operation that underflows adds at most 2⁻¹⁰⁷⁴, and later factors make that less
/// than 2⁻⁵⁰⁰; while V, E ≥ 2⁻¹⁰⁰ make the smallest bound, 64·2⁻¹⁰²·2⁻²⁰⁰, hundreds of binades more than that.

#if defined(DURERO_TRACE_CLOSED_FORM_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_CLOSED_FORM_INL_HPP_
#undef DURERO_TRACE_CLOSED_FORM_INL_HPP_
#else
#define DURERO_TRACE_CLOSED_FORM_INL_HPP_
#endif

#include <cmath>
#include <limits>

#include "durero/trace/double_double-inl.hpp"
#include "durero/trace/steps.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

// What an algorithm over T asks of it: its unit roundoff, its leading part, and the difference of two binary64.
template <class T>
struct Numbers;

template <>
struct Numbers<double> {
  static constexpr double roundoff = 0x1p-53;
  static double leading(double a) { return a; }
  static double difference(double a, double b) { return a - b; }
};

template <>
struct Numbers<DoubleDouble> {
  static constexpr double roundoff = 0x1p-102;
  static double leading(const DoubleDouble& a) { return a.hi; }
  static DoubleDouble difference(double a, double b) { return two_sum(a, -b); }
};

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

template <class T>
HWY_INLINE double leading(const T& a) {
  return Numbers<T>::leading(a);
}

/// The sum of the magnitudes: at least the Euclidean length.
template <class T>
HWY_INLINE double extent(const Vec<T>& a) {
  return std::abs(leading(a.x)) + std::abs(leading(a.y)) + std::abs(leading(a.z));
}

/// The quantities of the comment above and a bound for the error of each, for a ray whose line meets the surface.
template <class T>
struct Quadratic {
  T A{}, B{}, C{};
  T S{};  ///< √D = √(F·H)
  double A_error = 0, B_error = 0, C_error = 0, S_error = 0;
  T s0{}, s1{};                 ///< avance at t is s0 + t·s1, for a sphere 0
  double altura = 0;            ///< ∞ for a sphere
  double reach = 0, speed = 0;  ///< |q| + altura and V: the bounds of avance and of its rate
};

/// The sign of the discriminant, then √D: D = F·H, where both factors are known to `error`.
enum class Discriminant { negative, positive, unknown };
template <class T>
HWY_INLINE Discriminant discriminant(const T& of_surface, const T& of_line, double error, Quadratic<T>& f) {
  using std::sqrt;
  const T F = of_surface - of_line;
  if (leading(F) < -error) return Discriminant::negative;
  if (!(leading(F) > error)) return Discriminant::unknown;
  // |F·H − D| ≤ error·(|F| + H) + error² ≤ 3·error·H, as error < F ≤ H; and |S − √D| = |S² − D|/(S + √D).
  const T H = of_surface + of_line;
  f.S = sqrt(F * H);
  f.S_error = 3 * error * leading(H) / leading(f.S) + 4 * Numbers<T>::roundoff * leading(f.S);
  return Discriminant::positive;
}

template <class T>
HWY_INLINE void set_errors(Quadratic<T>& f, double kappa, double V, double E) {
  const double unit = 64 * Numbers<T>::roundoff * kappa;
  f.A_error = unit * V * V;
  f.B_error = unit * V * E;
  f.C_error = unit * E * E;
}

template <class T>
HWY_INLINE Vec<T> difference(const glm::dvec3& a, const glm::dvec3& b) {
  using N = Numbers<T>;
  return {N::difference(a.x, b.x), N::difference(a.y, b.y), N::difference(a.z, b.z)};
}
template <class T>
HWY_INLINE Vec<T> vec(const glm::dvec3& a) {
  return {T(a.x), T(a.y), T(a.z)};
}

template <class T>
HWY_INLINE Discriminant prepare(const scene::Sphere& sphere, const Beam& beam, Quadratic<T>& f) {
  const Vec<T> q = difference<T>(beam.p, sphere.centro);
  const Vec<T> v = vec<T>(beam.v);
  const T r(sphere.radio);
  const double E = extent(q) + sphere.radio;
  set_errors(f, 1, beam.speed, E);
  f.A = dot(v, v);
  using std::sqrt;
  const Discriminant D = discriminant(T(r * sqrt(f.A)), length(cross(q, v)), f.B_error, f);
  f.B = dot(q, v);
  f.C = dot(q, q) - r * r;
  f.s0 = f.s1 = T(0);
  f.altura = std::numeric_limits<double>::infinity();
  f.reach = E;
  f.speed = beam.speed;
  return D;
}

/// What cylinder and cone share.
template <class T>
struct Axial {
  Vec<T> q, a, b;
  double Q;
};
template <class T>
HWY_INLINE Axial<T> axial(const glm::dvec3& centro, const glm::dvec3& vector, double altura, const Beam& beam,
                          Quadratic<T>& f) {
  const Vec<T> q = difference<T>(beam.p, centro);
  const Vec<T> v = vec<T>(beam.v), d = vec<T>(vector);
  f.s0 = dot(q, d);
  f.s1 = dot(v, d);
  f.altura = altura;
  f.speed = beam.speed;
  const double Q = extent(q);
  f.reach = Q + altura;
  return {q, across(v, f.s1, d), across(q, f.s0, d), Q};
}

template <class T>
HWY_INLINE Discriminant prepare(const scene::Cylinder& cylinder, const Beam& beam, Quadratic<T>& f) {
  const auto [q, a, b, Q] = axial<T>(cylinder.centro, cylinder.vector, cylinder.altura, beam, f);
  const T r(cylinder.radio);
  set_errors(f, 1, beam.speed, Q + cylinder.radio);
  f.A = dot(a, a);
  using std::sqrt;
  const Discriminant D = discriminant(T(r * sqrt(f.A)), length(cross(b, a)), f.B_error, f);
  f.B = dot(b, a);
  f.C = dot(b, b) - r * r;
  return D;
}

template <class T>
HWY_INLINE Discriminant prepare(const scene::Cone& cone, const Beam& beam, Quadratic<T>& f) {
  const auto [q, a, b, Q] = axial<T>(cone.centro, cone.vector, cone.altura, beam, f);
  const T k(cone.proporcion);
  set_errors(f, 1 + cone.proporcion * cone.proporcion, beam.speed, f.reach);
  const T g = T(cone.altura) - f.s0;
  const Discriminant D = discriminant(T(k * length(combination(g, a, f.s1, b))), length(cross(b, a)), f.B_error, f);
  const T k2 = k * k;
  f.A = dot(a, a) - k2 * (f.s1 * f.s1);
  f.B = dot(b, a) + k2 * (g * f.s1);
  f.C = dot(b, b) - k2 * (g * g);
  return D;
}

/// A root of the quadratic: within `error` of t.
template <class T>
struct Root {
  T t;
  double error;
};

/// The difference is rounded once, so its sign is right; with an infinite limit it is −∞ or NaN, and the answer false.
template <class T>
HWY_INLINE bool beyond(const Root<T>& root, double limit) {
  return leading(T(root.t - T(limit))) > root.error;
}

enum class Place { outside, inside, unknown };

/// t > 0 and 0 ≤ avance ≤ altura. avance at t errs by what s0 and s1 bring, 4ε|q| + 3ε|t|V, by |s1|·error, and by the
/// roundings of t·s1, of the sum and of altura − avance: in all less than 16ε(|q| + altura + |t|V) + |s1|·error.
template <class T>
HWY_INLINE Place place(const Quadratic<T>& f, const Root<T>& root) {
  const double t = leading(root.t);
  if (t < -root.error) return Place::outside;
  Place found = t > root.error ? Place::inside : Place::unknown;
  if (f.altura == std::numeric_limits<double>::infinity()) return found;
  const T s = f.s0 + root.t * f.s1;
  const double error = 16 * Numbers<T>::roundoff * (f.reach + std::abs(t) * f.speed) +
                       (std::abs(leading(f.s1)) * 1.0000001) * root.error;
  const double below = leading(s), above = leading(T(f.altura) - s);
  if (below < -error || above < -error) return Place::outside;
  return below > error && above > error ? found : Place::unknown;
}

/// What a step knows of the first point, in its own numbers.
template <class T>
struct Found {
  Verdict verdict;
  T t{};
  double error = 0;
  Slope slope{};
};

template <class T>
HWY_INLINE Found<T> found_at(const Quadratic<T>& f, const Root<T>& root, const T& slope, double slope_error) {
  return {Verdict::hit, root.t, root.error, {leading(slope), slope_error, leading(f.A), f.A_error}};
}

/// x/y where each is known to its error: |x/y − x̂/ŷ| ≤ (x_error + |x̂/ŷ|·y_error)/(|ŷ| − y_error), and a rounding.
/// Precondition: |ŷ| > 2·y_error.
template <class T>
HWY_INLINE Root<T> quotient(const T& x, double x_error, const T& y, double y_error) {
  const T t = x / y;
  const double size = std::abs(leading(t));
  const double error = (x_error + size * y_error) / (std::abs(leading(y)) - y_error);
  return {t, error * 1.0000001 + 4 * Numbers<T>::roundoff * size};
}

/// The first of the two roots that is a point of the element, the nearer one first; beyond `limit` nothing matters.
template <class T>
HWY_INLINE Found<T> first_of(const Quadratic<T>& f, double limit) {
  using std::abs;
  // q = −(B + σS) with the sign σ of the computed B: for either sign the roots are q/A and C/q, and A·t + B there −σS
  // and σS. So q/A is the smaller one where σ and A agree in sign.
  const bool positive = leading(f.B) >= 0;
  const T S = positive ? f.S : -f.S;
  const T q = -(f.B + S);
  const double size = abs(leading(q));
  const double q_error = f.B_error + f.S_error + 2 * Numbers<T>::roundoff * size;
  if (!(size > 2 * q_error)) return {Verdict::undecided};

  const double A = leading(f.A);
  const bool A_known = abs(A) > 2 * f.A_error;
  // Where A may be 0, |q/A| is at least this, which may already be beyond the element or the limit.
  bool far_away = false;
  if (!A_known) {
    const double least = 0.9999999 * (size - q_error) / (abs(A) + f.A_error);
    const double rate = abs(leading(f.s1)) - 4 * Numbers<T>::roundoff * f.speed;
    far_away = least > limit || (f.altura < std::numeric_limits<double>::infinity() && least * rate > 2 * f.reach);
    if (!far_away) return {Verdict::undecided};
  }
  const bool A_root_first = (A > 0) == positive;
  for (int turn = 0; turn < 2; ++turn) {
    const bool A_root = (turn == 0) == A_root_first;
    if (A_root && far_away) continue;
    const Root<T> root = A_root ? quotient(q, q_error, f.A, f.A_error) : quotient(f.C, f.C_error, q, q_error);
    if (beyond(root, limit)) return {Verdict::miss};
    const Place where = place(f, root);
    if (where == Place::unknown) return {Verdict::undecided};
    if (where == Place::inside) return found_at(f, root, A_root ? T(-S) : S, f.S_error);
  }
  return {Verdict::miss};
}

/// The ray starts on the element, so C = 0: the roots are 0, which is no point of the ray, and −2B/A.
template <class T>
HWY_INLINE Found<T> first_from_surface(const Quadratic<T>& f, double limit) {
  if (!(std::abs(leading(f.A)) > 2 * f.A_error)) return {Verdict::undecided};
  const Root<T> root = quotient(T(-(f.B + f.B)), 2 * f.B_error, f.A, f.A_error);
  if (beyond(root, limit)) return {Verdict::miss};
  const Place where = place(f, root);
  if (where == Place::unknown) return {Verdict::undecided};
  return where == Place::inside ? found_at(f, root, T(-f.B), f.B_error) : Found<T>{Verdict::miss};
}

/// The first point of the ray on the element, or none (none up to the limit), or that this T cannot tell.
/// on: the ray starts on the element. Precondition: element and beam are ordinary.
template <class T, class Element>
HWY_INLINE Found<T> closed_form(const Element& element, const Beam& beam, bool on, double limit) {
  Quadratic<T> f;
  const Discriminant D = prepare<T>(element, beam, f);
  if (on) return first_from_surface(f, limit);
  if (D == Discriminant::negative) return {Verdict::miss};
  if (D == Discriminant::unknown) return {Verdict::undecided};
  return first_of(f, limit);
}

template <class T>
HWY_INLINE Finding published(const Found<T>& found) {
  if constexpr (requires { found.t.lo; }) {
    return {found.verdict, found.t.hi, found.t.lo, found.error, found.slope};
  } else {
    return {found.verdict, found.t, 0, found.error, found.slope};
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
