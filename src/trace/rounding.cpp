// The parameter and the point of a hit, rounded once. A root known from the triage to some forty bits is improved by
// one step of Newton's to some ninety, which nearly always decide the rounding.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/rounding.cpp"  // as seen from src/
#include <hwy/foreach_target.h>
//
#include "durero/trace/pack_lanes-inl.hpp"
#include "durero/trace/power-inl.hpp"
#include "durero/trace/rounding-inl.hpp"
#include "durero/trace/steps.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {
namespace {

using model::Tipo;

Rounded rounded_of(const Beam& beam, const Finding& finding) {
  const Pair<double> t(finding.hi, finding.lo);
  const Once<double> of_t = round_once(t, finding.error);
  const Once<double> x = round_coordinate(beam.p.x, beam.v.x, t, finding.error);
  const Once<double> y = round_coordinate(beam.p.y, beam.v.y, t, finding.error);
  const Once<double> z = round_coordinate(beam.p.z, beam.v.z, t, finding.error);
  return {of_t.certain && x.certain && y.certain && z.certain, of_t.value, {x.value, y.value, z.value}};
}

template <class Element>
Finding improved_of(const Element& element, const Beam& beam, bool on, const Finding& finding) {
  const Slope& slope = finding.slope;
  const Improved<double> better = newton<double>({finding.hi, finding.error}, {slope.at_root, slope.at_root_error},
                                                 {slope.A, slope.A_error}, quadratic_at(finding.hi, element, beam, on));
  if (!better.known) return {Verdict::undecided};
  return {Verdict::hit, better.t.hi, better.t.lo, better.error, slope};
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

template <Tipo tipo>
void round_lanes(const Pack& pack, const Findings& findings, RoundedPack& result) {
  using Column = Pack::Column;
  result.certain = 0;
  for (std::size_t at = 0; at < Pack::size; at += lanes()) {
    const LaneBeam ray = beam(pack, at);
    const LaneElement<tipo> e = element<tipo>(pack, at);
    const auto load = [at](const Column& column) HWY_ATTR { return Lanes::load(&column[at]); };
    const Lanes t = load(findings.t);
    const Improved<Lanes> better =
        newton<Lanes>({t, load(findings.error)}, {load(findings.at_root), load(findings.at_root_error)},
                      {load(findings.A), load(findings.A_error)}, power(e, place_at(t, ray, e.centro)));
    const Once<Lanes> of_t = round_once(better.t, better.error);
    const Once<Lanes> x = round_coordinate(ray.p.x, ray.v.x, better.t, better.error);
    const Once<Lanes> y = round_coordinate(ray.p.y, ray.v.y, better.t, better.error);
    const Once<Lanes> z = round_coordinate(ray.p.z, ray.v.z, better.t, better.error);
    of_t.value.store(&result.t[at]);
    x.value.store(&result.x[at]);
    y.value.store(&result.y[at]);
    z.value.store(&result.z[at]);
    result.certain |= bits(better.known & of_t.certain & x.certain & y.certain & z.certain) << at;
  }
}

void round_pack(const Pack& pack, Tipo tipo, const Findings& findings, RoundedPack& result) {
  switch (tipo) {
    case Tipo::soy_esfera:
      return round_lanes<Tipo::soy_esfera>(pack, findings, result);
    case Tipo::soy_cilindro:
      return round_lanes<Tipo::soy_cilindro>(pack, findings, result);
    default:
      return round_lanes<Tipo::soy_cono>(pack, findings, result);
  }
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
HWY_EXPORT(round_pack);

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

void improve_and_round(const Pack& pack, model::Tipo tipo, const Findings& findings, RoundedPack& result) {
  HWY_DYNAMIC_DISPATCH(round_pack)(pack, tipo, findings, result);
}

}  // namespace durero::trace
#endif
