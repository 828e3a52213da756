// The parameter and the point of a hit, rounded once. The triage knows a root to some forty bits; one step of Newton's
// improves it to some ninety, which nearly always decide the rounding.
#define HWY_TARGET_INCLUDE "trace/rounding.cpp"  // as seen from src/
#include "lanes/for_each_target.hpp"
//
#include "trace/packet_lanes-inl.hpp"
#include "trace/rounding-inl.hpp"
#include "trace/shapes-inl.hpp"
#include "trace/steps.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {
namespace {

using model::Tipo;

RoundedPoint rounded_of(scene::ShapeView element, const Ray& ray, const RootEstimate& finding) {
  const Pair<double> t(finding.hi, finding.lo);
  const OncePoint<double> once =
      element.visit([&](const auto& shape) HWY_ATTR { return round_point_on(shape, ray, t, finding.error); });
  return {once.certain, once.t, {once.x, once.y, once.z}};
}

RootEstimate improved_of(scene::ShapeView element, const Ray& ray, bool on, const RootEstimate& finding) {
  const Slope& slope = finding.slope;
  const Power<double> at =
      element.visit([&](const auto& shape) HWY_ATTR { return quadratic_at(finding.hi, shape, ray, on); });
  const RefinedRoot<double> better =
      newton<double>({finding.hi, finding.error}, {slope.at_root, slope.at_root_error}, {slope.A, slope.A_error}, at);
  if (!better.known) return {Decision::undecided};
  return {Decision::hit, better.t.hi, better.t.lo, better.error, slope};
}

/// `own`: the rays start on their elements.
template <Tipo tipo, bool own>
void round_lanes(const Packet& packet, const Findings& findings, RoundedPacket& result) {
  using Column = Packet::Column;
  result.certain = 0;
  for (std::size_t at = 0; at < Packet::size; at += lanes()) {
    const LaneRay ray = rays(packet, at);
    const LaneElement<tipo> e = element<tipo>(packet, at);
    const auto load = [at](const Column& column) HWY_ATTR { return Lanes::load(&column[at]); };
    const Lanes t = load(findings.t);
    const Power<Lanes> f = own ? own_quadratic_at(t, e, ray) : power_at(t, e, ray);
    const RefinedRoot<Lanes> better =
        newton<Lanes>({t, load(findings.error)}, {load(findings.at_root), load(findings.at_root_error)},
                      {load(findings.A), load(findings.A_error)}, f);
    const OncePoint<Lanes> once = round_point_on(e, ray, better.t, better.error);
    once.t.store(&result.t[at]);
    once.x.store(&result.x[at]);
    once.y.store(&result.y[at]);
    once.z.store(&result.z[at]);
    result.certain |= bits(better.known & once.certain) << at;
  }
}

void round_packet(const Packet& packet, Tipo tipo, const Findings& findings, RoundedPacket& result) {
  scene::with_shape(tipo, [&]<class Shape>(std::type_identity<Shape>)
                              HWY_ATTR { round_lanes<Shape::tipo, false>(packet, findings, result); });
}

void round_packet_from(const Packet& packet, Tipo tipo, const Findings& findings, RoundedPacket& result) {
  scene::with_shape(tipo, [&]<class Shape>(std::type_identity<Shape>)
                              HWY_ATTR { round_lanes<Shape::tipo, true>(packet, findings, result); });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::trace {
namespace {

HWY_EXPORT(improved_of);
HWY_EXPORT(rounded_of);
HWY_EXPORT(round_packet);
HWY_EXPORT(round_packet_from);

}  // namespace

RootEstimate improved(scene::ShapeView element, const Ray& ray, bool on, const RootEstimate& finding) {
  return HWY_DYNAMIC_DISPATCH(improved_of)(element, ray, on, finding);
}
RoundedPoint rounded(scene::ShapeView element, const Ray& ray, const RootEstimate& finding) {
  return HWY_DYNAMIC_DISPATCH(rounded_of)(element, ray, finding);
}

void improve_and_round(const Packet& packet, model::Tipo tipo, const Findings& findings, RoundedPacket& result) {
  HWY_DYNAMIC_DISPATCH(round_packet)(packet, tipo, findings, result);
}
void improve_and_round_from(const Packet& packet, model::Tipo tipo, const Findings& findings, RoundedPacket& result) {
  HWY_DYNAMIC_DISPATCH(round_packet_from)(packet, tipo, findings, result);
}

}  // namespace durero::trace
#endif
