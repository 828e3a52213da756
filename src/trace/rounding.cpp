// The parameter and the point of a hit, rounded once. A root known from the triage to some forty bits is improved by
// one step of Newton's to some ninety, which nearly always decide the rounding.
//
// Numbers here are sums hi + lo of two binary64 that need not be normalised: sums and products of the leading parts are
// split exactly into hi and a remainder, remainders are added up in binary64. With u = 2⁻⁵³ a remainder is a few u of
// what it belongs to, so a rounding of it is of the order of u².
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/rounding.cpp"  // as seen from src/
#include <hwy/foreach_target.h>
//
#include <cmath>

#include "durero/trace/closed_form-inl.hpp"
#include "durero/trace/steps.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {
namespace {

using Pair = DoubleDouble;  // hi + lo, here not always normalised

/// The square: (hi + lo)² = hi² + (2hi + lo)·lo.
HWY_INLINE Pair square(const Pair& a) {
  const Pair high = two_prod(a.hi, a.hi);
  return {high.hi, high.lo + (2 * a.hi + a.lo) * a.lo};
}

HWY_INLINE Pair sum(const Pair& a, const Pair& b) {
  const Pair high = two_sum(a.hi, b.hi);
  return {high.hi, high.lo + (a.lo + b.lo)};
}
HWY_INLINE Pair difference(const Pair& a, const Pair& b) { return sum(a, -b); }

HWY_INLINE Pair product(const Pair& a, double b) {
  const Pair high = two_prod(a.hi, b);
  return {high.hi, high.lo + a.lo * b};
}

/// p + t·v − c along each axis, and W ≥ |p − centro| + |t·v|.
struct Place3 {
  Pair x, y, z;
  double W;
};

HWY_INLINE Place3 place_at(double t, const Beam& beam, const glm::dvec3& centro) {
  const Pair a = two_sum(beam.p.x, -centro.x), b = two_sum(beam.p.y, -centro.y), c = two_sum(beam.p.z, -centro.z);
  const double W = std::abs(a.hi) + std::abs(b.hi) + std::abs(c.hi) + std::abs(t) * beam.speed;
  return {sum(a, two_prod(t, beam.v.x)), sum(b, two_prod(t, beam.v.y)), sum(c, two_prod(t, beam.v.z)), W};
}

HWY_INLINE Pair squared_length(const Place3& q) { return sum(sum(square(q.x), square(q.y)), square(q.z)); }

HWY_INLINE Pair avance(const Place3& q, const glm::dvec3& d) {
  return sum(sum(product(q.x, d.x), product(q.y, d.y)), product(q.z, d.z));
}

/// d·d − 1, at most 2⁻⁵⁰: the sum of the leading squares less 1 is exact or nearly so, as they are close to 1.
HWY_INLINE double excess(const glm::dvec3& d) {
  const Pair n = sum(sum(two_prod(d.x, d.x), two_prod(d.y, d.y)), two_prod(d.z, d.z));
  return (n.hi - 1) + n.lo;
}

/// |q − s·d|² = |q|² − (2 − d·d)·s² = |q|² − s² + (d·d − 1)·s²
HWY_INLINE Pair alejamiento(const Place3& q, const Pair& s, const glm::dvec3& d) {
  const Pair across = difference(squared_length(q), square(s));
  return {across.hi, across.lo + excess(d) * (s.hi * s.hi)};
}

/// potencia at a point of the ray, and a bound on its error. In units of u·κ·M², M = W + r or W + altura: |q|'s lower
/// parts are at most 3u·W in all, those of s 10u·W, of altura − s 11u·M, and with the remainders of the squares and
/// sums all lower parts of the value come to less than 100. Each passes through at most 12 roundings: 1200u²·κM².
/// What is lost where lower parts are rounded before a square is at most 2·(6 + 12·10)u²·κM². In all below 2⁻⁹⁵κM²
/// = 2048u²·κM², and the last subtraction's part for a ray that starts on the element below another 2⁻⁹⁵κM².
struct Power {
  Pair value;
  double error;
};
constexpr double power_error = 0x1p-95;

HWY_INLINE Power power(const scene::Sphere& sphere, const Place3& q) {
  const double M = q.W + sphere.radio;
  return {difference(squared_length(q), two_prod(sphere.radio, sphere.radio)), power_error * M * M};
}

HWY_INLINE Power power(const scene::Cylinder& cylinder, const Place3& q) {
  const double M = q.W + cylinder.radio;
  const Pair away = alejamiento(q, avance(q, cylinder.vector), cylinder.vector);
  return {difference(away, two_prod(cylinder.radio, cylinder.radio)), power_error * M * M};
}

HWY_INLINE Power power(const scene::Cone& cone, const Place3& q) {
  const double M = q.W + cone.altura, k = cone.proporcion;
  const Pair s = avance(q, cone.vector);
  const Pair radius = product(difference(Pair(cone.altura), s), k);
  return {difference(alejamiento(q, s, cone.vector), square(radius)), power_error * (1 + k * k) * M * M};
}

/// The quadratic at t: potencia, less that at the origin where the ray starts on the element.
template <class Element>
HWY_INLINE Power quadratic_at(double t, const Element& element, const Beam& beam, bool on) {
  const Power there = power(element, place_at(t, beam, element.centro));
  if (!on) return there;
  const Power here = power(element, place_at(0, beam, element.centro));
  return {difference(there.value, here.value), there.error + 2 * here.error};
}

/// With δ = t* − t the way to the root t*, σ = A·t* + B and f the quadratic at t, f = −2σδ + Aδ². So δ = −f/(2σ − Aδ),
/// and |δ| ≤ error bounds the last term.
template <class Element>
Finding improved_of(const Element& element, const Beam& beam, bool on, const Finding& finding) {
  const auto [f, f_error] = quadratic_at(finding.hi, element, beam, on);
  const Slope& slope = finding.slope;
  const double denominator = 2 * slope.at_root;
  const double denominator_error =
      1.0000001 * (2 * slope.at_root_error + (std::abs(slope.A) + slope.A_error) * finding.error);
  if (!(std::abs(denominator) > 2 * denominator_error)) return {Verdict::undecided};
  const double value = f.hi + f.lo;
  const Root<double> delta = quotient(-value, f_error + 0x1p-52 * std::abs(value), denominator, denominator_error);
  const Pair t = two_sum(finding.hi, delta.t);
  return {Verdict::hit, t.hi, t.lo, delta.error, slope};
}

/// Rounds x where every number within the error of it rounds the same: rounding is monotone, and hi + (lo ± error) is
/// one rounded sum. The last term pays for the rounding of lo ± error. Numbers near the ends of the range are left to
/// the exact step.
HWY_INLINE bool round_once(const Pair& x, double error, double& result) {
  const double wide = 1.0000001 * error + 0x1p-52 * std::abs(x.lo);
  const double low = x.hi + (x.lo - wide), high = x.hi + (x.lo + wide);
  result = low;
  return low == high && std::abs(low) > 0x1p-900 && std::abs(low) < 0x1p900;
}

/// p + t·v. The lower part is of two remainders and t.lo·v, together at most 3u(|p| + |t·v|), and passes through three
/// roundings; beside that the error of t.
HWY_INLINE bool round_coordinate(double p, double v, const Pair& t, double t_error, double& result) {
  const Pair way = product(t, v);
  const Pair x = sum(way, Pair(p));
  const double error = std::abs(v) * t_error + 0x1p-102 * (std::abs(way.hi) + std::abs(p));
  const bool certain = round_once(x, error, result);
  if (v != 0) return certain;
  result = p + 0.0;  // exactly p; 0 for −0
  return true;
}

Rounded rounded_of(const Beam& beam, const Finding& finding) {
  const Pair t(finding.hi, finding.lo);
  const double error = finding.error;
  Rounded r{};
  const bool of_t = round_once(t, error, r.t);
  const bool of_x = round_coordinate(beam.p.x, beam.v.x, t, error, r.punto.x);
  const bool of_y = round_coordinate(beam.p.y, beam.v.y, t, error, r.punto.y);
  const bool of_z = round_coordinate(beam.p.z, beam.v.z, t, error, r.punto.z);
  r.certain = of_t && of_x && of_y && of_z;
  return r;
}

Finding improved_sphere(const scene::Sphere& e, const Beam& b, bool on, const Finding& f) {
  return improved_of(e, b, on, f);
}
Finding improved_cylinder(const scene::Cylinder& e, const Beam& b, bool on, const Finding& f) {
  return improved_of(e, b, on, f);
}
Finding improved_cone(const scene::Cone& e, const Beam& b, bool on, const Finding& f) {
  return improved_of(e, b, on, f);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::trace {
namespace {

HWY_EXPORT(improved_sphere);
HWY_EXPORT(improved_cylinder);
HWY_EXPORT(improved_cone);
HWY_EXPORT(rounded_of);

}  // namespace

Finding improved(const scene::Sphere& e, const Beam& b, bool on, const Finding& f) {
  return HWY_DYNAMIC_DISPATCH(improved_sphere)(e, b, on, f);
}
Finding improved(const scene::Cylinder& e, const Beam& b, bool on, const Finding& f) {
  return HWY_DYNAMIC_DISPATCH(improved_cylinder)(e, b, on, f);
}
Finding improved(const scene::Cone& e, const Beam& b, bool on, const Finding& f) {
  return HWY_DYNAMIC_DISPATCH(improved_cone)(e, b, on, f);
}
Rounded rounded(const Beam& b, const Finding& f) { return HWY_DYNAMIC_DISPATCH(rounded_of)(b, f); }

}  // namespace durero::trace
#endif
