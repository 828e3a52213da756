#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/stable.cpp"  // as seen from src/
#include <hwy/foreach_target.h>
//
#include <cmath>

#include "durero/trace/closed_form-inl.hpp"
#include "durero/trace/steps.hpp"
#include "kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {
namespace {

using Number = DoubleDouble;
constexpr double roundoff = Numbers<Number>::roundoff;

template <class Element>
Finding stable_of(const Element& element, const Beam& beam, bool on, double limit) {
  return published(closed_form<Number>(element, beam, on, limit));
}

/// potencia at centro + q and its error: the C of the closed forms, with q for the origin.
struct Power {
  Number value;
  double error;
};

Power power(const scene::Sphere& sphere, const Vec<Number>& q) {
  const double E = extent(q) + sphere.radio;
  return {dot(q, q) - two_prod(sphere.radio, sphere.radio), 64 * roundoff * E * E};
}

Power power(const scene::Cylinder& cylinder, const Vec<Number>& q) {
  const Vec<Number> d = vec<Number>(cylinder.vector);
  const Vec<Number> b = across(q, dot(q, d), d);
  const double E = extent(q) + cylinder.radio;
  return {dot(b, b) - two_prod(cylinder.radio, cylinder.radio), 64 * roundoff * E * E};
}

Power power(const scene::Cone& cone, const Vec<Number>& q) {
  const Vec<Number> d = vec<Number>(cone.vector);
  const Number s = dot(q, d);
  const Vec<Number> b = across(q, s, d);
  const Number g = Number(cone.altura) - s;
  const double E = extent(q) + cone.altura;
  const double kappa = 1 + cone.proporcion * cone.proporcion;
  return {dot(b, b) - two_prod(cone.proporcion, cone.proporcion) * (g * g), 64 * roundoff * kappa * E * E};
}

/// With δ = t* − t the way to the root t*, σ = A·t* + B and f = potencia at t, f = −2σδ + Aδ². So δ = −f/(2σ − Aδ),
/// and |δ| ≤ error bounds the last term.
template <class Element>
Finding improved_of(const Element& element, const Beam& beam, const Finding& finding) {
  const auto component = [&](double p, double v, double c) { return two_prod(finding.hi, v) + two_sum(p, -c); };
  const Vec<Number> q{component(beam.p.x, beam.v.x, element.centro.x), component(beam.p.y, beam.v.y, element.centro.y),
                      component(beam.p.z, beam.v.z, element.centro.z)};
  const auto [f, f_error] = power(element, q);
  const Slope& slope = finding.slope;
  const double denominator = 2 * slope.at_root;
  const double denominator_error =
      1.0000001 * (2 * slope.at_root_error + (std::abs(slope.A) + slope.A_error) * finding.error);
  if (!(std::abs(denominator) > 2 * denominator_error)) return {Verdict::undecided};
  const Root<double> delta = quotient(-f.hi, f_error + 0x1p-53 * std::abs(f.hi), denominator, denominator_error);
  const Number t = two_sum(finding.hi, delta.t);
  return {Verdict::hit, t.hi, t.lo, delta.error, slope};
}

/// Rounds x where every number within the error of it rounds the same: rounding is monotone, and hi + (lo ± error) is
/// one rounded sum. The last term pays for the rounding of lo ± error. Numbers near the ends of the range are left to
/// the exact step.
bool round_once(const Number& x, double error, double& result) {
  const double wide = 1.0000001 * error + 0x1p-52 * std::abs(x.lo);
  const double low = x.hi + (x.lo - wide), high = x.hi + (x.lo + wide);
  result = low;
  return low == high && std::abs(low) > 0x1p-900 && std::abs(low) < 0x1p900;
}

/// p + t·v: the product errs by ε|t·v| and the sum by ε of itself, beside what t brings.
bool round_coordinate(double p, double v, const Number& t, double t_error, double& result) {
  if (v == 0) {
    result = p + 0.0;  // 0 for −0
    return true;
  }
  const Number way = t * v;
  const Number x = way + Number(p);
  const double error = std::abs(v) * t_error + roundoff * (std::abs(way.hi) + std::abs(x.hi));
  return round_once(x, error, result);
}

Rounded rounded_of(const Beam& beam, const Finding& finding) {
  const Number t(finding.hi, finding.lo);
  const double error = finding.error;
  Rounded r{};
  r.certain = round_once(t, error, r.t) && round_coordinate(beam.p.x, beam.v.x, t, error, r.punto.x) &&
              round_coordinate(beam.p.y, beam.v.y, t, error, r.punto.y) &&
              round_coordinate(beam.p.z, beam.v.z, t, error, r.punto.z);
  return r;
}

StableKernels table() {
  return {stable_of<scene::Sphere>,
          stable_of<scene::Cylinder>,
          stable_of<scene::Cone>,
          improved_of<scene::Sphere>,
          improved_of<scene::Cylinder>,
          improved_of<scene::Cone>,
          rounded_of};
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::trace {
namespace {

HWY_EXPORT(table);

/// Chosen once, for the machine at hand.
const StableKernels& kernels() {
  static const StableKernels chosen = HWY_DYNAMIC_DISPATCH(table)();
  return chosen;
}

}  // namespace

Finding stable(const scene::Sphere& e, const Beam& b, bool on, double limit) {
  return kernels().sphere(e, b, on, limit);
}
Finding stable(const scene::Cylinder& e, const Beam& b, bool on, double limit) {
  return kernels().cylinder(e, b, on, limit);
}
Finding stable(const scene::Cone& e, const Beam& b, bool on, double limit) { return kernels().cone(e, b, on, limit); }
Finding improved(const scene::Sphere& e, const Beam& b, const Finding& f) { return kernels().improved_sphere(e, b, f); }
Finding improved(const scene::Cylinder& e, const Beam& b, const Finding& f) {
  return kernels().improved_cylinder(e, b, f);
}
Finding improved(const scene::Cone& e, const Beam& b, const Finding& f) { return kernels().improved_cone(e, b, f); }
Rounded rounded(const Beam& b, const Finding& f) { return kernels().rounded(b, f); }

}  // namespace durero::trace
#endif
