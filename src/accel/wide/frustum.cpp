#define HWY_TARGET_INCLUDE "accel/wide/frustum.cpp"  // as seen from src/
#include "lanes/for_each_target.hpp"
//
#include <algorithm>
#include <cmath>

#include "accel/wide/wide_lanes-inl.hpp"
#include "durero/accel/wide/frustum.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::accel {
namespace HWY_NAMESPACE {
namespace {

/// The range of the numbers that were joined to it, lane by lane.
struct LaneExtent {
  HWY_INLINE LaneExtent() : least(hn::Set(Tag(), HUGE_VAL)), greatest(hn::Set(Tag(), -HUGE_VAL)) {}
  HWY_INLINE void join(Lanes x) { least = hn::Min(least, x), greatest = hn::Max(greatest, x); }
  HWY_INLINE double low() const { return hn::GetLane(hn::MinOfLanes(Tag(), least)); }
  HWY_INLINE double high() const { return hn::GetLane(hn::MaxOfLanes(Tag(), greatest)); }

  Lanes least, greatest;
};

/// An axis of some rays, in lanes. The end of a ray that takes no part is its origin.
struct LaneAxis {
  HWY_INLINE LaneAxis(const WidePacket& bundle, std::size_t axis, std::size_t at)
      : p(hn::LoadU(Tag(), &bundle.rays.p[axis][at])), v(hn::LoadU(Tag(), &bundle.rays.v[axis][at])) {
    const auto walks = hn::Ge(hn::LoadU(Tag(), &bundle.limit[at]), hn::Zero(Tag()));
    end = hn::IfThenElse(walks, hn::Add(p, v), p);
  }
  Lanes p, v, end;
};

/// The ranges of the origins, the ends and the slopes of the rays, along one axis.
struct Ranges {
  HWY_INLINE Ranges() {}
  HWY_INLINE double low() const { return std::min(p.low(), end.low()); }
  HWY_INLINE double high() const { return std::max(p.high(), end.high()); }
  HWY_INLINE double size(const surface::Box& all, int axis) const {
    return std::max(std::max(-low(), high()), std::max(std::abs(all.low[axis]), std::abs(all.high[axis])));
  }
  HWY_INLINE bool converge() const { return end.high() - end.low() <= p.high() - p.low(); }

  LaneExtent p, end, slope;
};

constexpr double slack = 0x1p-48;  // 32u

Frustum beam_in_lanes(const WidePacket& bundle, const surface::Box& all) {
  const auto lanes = hn::Lanes(Tag());
  const auto speed = [&](std::size_t axis) HWY_ATTR { return std::abs(bundle.rays.v[axis][bundle.begin]); };
  Frustum beam;
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (speed(axis) > speed(beam.along)) beam.along = axis;
  beam.across = {(beam.along + 1) % 3, (beam.along + 2) % 3};
  Ranges y, x[2];
  for (std::size_t at = bundle.begin; at < bundle.end; at += lanes) {
    const LaneAxis along(bundle, beam.along, at);
    y.p.join(along.p), y.end.join(along.end);
    for (std::size_t i = 0; i < 2; ++i) {
      const LaneAxis across(bundle, beam.across[i], at);
      x[i].p.join(across.p), x[i].end.join(across.end), x[i].slope.join(hn::Div(across.v, along.v));
    }
  }
  const auto axis_along = static_cast<int>(beam.along);
  const double Y = y.size(all, axis_along);
  beam.from = y.low() - slack * Y - tiny, beam.to = y.high() + slack * Y + tiny;
  const bool forwards = bundle.rays.v[beam.along][bundle.begin] > 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const bool steep = x[i].converge() == forwards;
    beam.low[i].slope = steep ? x[i].slope.high() : x[i].slope.low();
    beam.high[i].slope = steep ? x[i].slope.low() : x[i].slope.high();
    const Lanes b = hn::Set(Tag(), beam.low[i].slope), d = hn::Set(Tag(), beam.high[i].slope);
    LaneExtent of_low, of_high;
    for (std::size_t at = bundle.begin; at < bundle.end; at += lanes) {
      const LaneAxis along(bundle, beam.along, at), across(bundle, beam.across[i], at);
      of_low.join(hn::Sub(across.p, hn::Mul(b, along.p))), of_low.join(hn::Sub(across.end, hn::Mul(b, along.end)));
      of_high.join(hn::Sub(across.p, hn::Mul(d, along.p))), of_high.join(hn::Sub(across.end, hn::Mul(d, along.end)));
    }
    const double X = x[i].size(all, static_cast<int>(beam.across[i]));
    beam.low[i].bound = of_low.low() - (slack * (X + std::abs(beam.low[i].slope) * Y) + tiny);
    beam.high[i].bound = of_high.high() + (slack * (X + std::abs(beam.high[i].slope) * Y) + tiny);
    for (const double at : {std::max(beam.from, all.low[axis_along]), std::min(beam.to, all.high[axis_along])}) {
      const double width = beam.high[i].bound - beam.low[i].bound + (beam.high[i].slope - beam.low[i].slope) * at;
      beam.width = width <= beam.width ? beam.width : width;
    }
    if (!std::isfinite(beam.low[i].slope) || !std::isfinite(beam.high[i].slope)) beam.width = HUGE_VAL;
  }
  return beam;
}

unsigned met_by_beam(const WideNode& node, const Frustum& beam) {
  const Tag tag;
  unsigned met = 0;
  for (std::size_t at = 0; at < WideNode::width; at += hn::Lanes(tag)) {
    const Lanes first = planes(node, beam.along, at), last = planes(node, beam.along + 3, at);
    auto within = hn::And(hn::Le(first, hn::Set(tag, beam.to)), hn::Ge(last, hn::Set(tag, beam.from)));
    for (std::size_t i = 0; i < 2; ++i) {
      const auto [b, of_low] = beam.low[i];
      const auto [d, of_high] = beam.high[i];
      const Lanes least = planes(node, beam.across[i], at), greatest = planes(node, beam.across[i] + 3, at);
      const Lanes above = hn::Sub(greatest, hn::Mul(hn::Set(tag, b), b >= 0 ? first : last));
      const Lanes below = hn::Sub(least, hn::Mul(hn::Set(tag, d), d >= 0 ? last : first));
      within = hn::And(within, hn::And(hn::Ge(above, hn::Set(tag, of_low)), hn::Le(below, hn::Set(tag, of_high))));
    }
    met |= bits(within) << at;
  }
  return met;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::accel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::accel {
namespace {
HWY_EXPORT(beam_in_lanes);
HWY_EXPORT(met_by_beam);
}  // namespace

Frustum beam_of(const WidePacket& bundle, const surface::Box& all) {
  return HWY_DYNAMIC_DISPATCH(beam_in_lanes)(bundle, all);
}
unsigned met(const WideNode& node, const Frustum& beam) { return HWY_DYNAMIC_DISPATCH(met_by_beam)(node, beam); }

}  // namespace durero::accel
#endif
