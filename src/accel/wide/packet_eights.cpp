#define HWY_TARGET_INCLUDE "accel/wide/packet_eights.cpp"  // as seen from src/
#include "lanes/for_each_target.hpp"
//
#include <algorithm>
#include <bit>

#include "accel/wide/wide_lanes-inl.hpp"
#include "durero/accel/wide/packet_eights.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::accel {
namespace HWY_NAMESPACE {
namespace {

/// The greatest limit of the eight rays from `begin` on.
HWY_INLINE double greatest_limit(const WidePacket& bundle, std::size_t begin) {
  const Tag tag;
  Lanes greatest = hn::LoadU(tag, &bundle.limit[begin]);
  for (std::size_t at = hn::Lanes(tag); at < WidePacket::eight; at += hn::Lanes(tag))
    greatest = hn::Max(greatest, hn::LoadU(tag, &bundle.limit[begin + at]));
  return hn::GetLane(hn::MaxOfLanes(tag, greatest));
}

/// The range of a column in each group of eight.
HWY_INLINE void enclose(const WidePacket& bundle, const WidePacket::Column& column, WidePacketEights::Column& low,
                        WidePacketEights::Column& high) {
  const Tag tag;
  for (std::size_t begin = bundle.begin; begin < bundle.end; begin += WidePacket::eight) {
    Lanes least = hn::LoadU(tag, &column[begin]), greatest = least;
    for (std::size_t at = hn::Lanes(tag); at < WidePacket::eight; at += hn::Lanes(tag)) {
      const Lanes some = hn::LoadU(tag, &column[begin + at]);
      least = hn::Min(least, some), greatest = hn::Max(greatest, some);
    }
    low[begin / WidePacket::eight] = hn::GetLane(hn::MinOfLanes(tag, least));
    high[begin / WidePacket::eight] = hn::GetLane(hn::MaxOfLanes(tag, greatest));
  }
}

void gather_eights(WidePacketEights& eights, const WidePacket& bundle) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    enclose(bundle, bundle.rays.p[axis], eights.p_low[axis], eights.p_high[axis]);
    enclose(bundle, bundle.inverse[axis], eights.inverse_low[axis], eights.inverse_high[axis]);
  }
  eights.limit.fill(-1);
  for (std::size_t begin = bundle.begin; begin < bundle.end; begin += WidePacket::eight)
    eights.limit[begin / WidePacket::eight] = greatest_limit(bundle, begin);
}

double bring_eights_up_to_date(WidePacketEights& eights, const WidePacket& bundle, std::uint64_t which) {
  for (std::size_t eight = 0; which != 0; ++eight, which >>= WidePacket::eight)
    if ((which & ((1u << WidePacket::eight) - 1)) != 0)
      eights.limit[eight] = greatest_limit(bundle, eight * WidePacket::eight);
  const Tag tag;
  Lanes greatest = hn::Zero(tag);
  for (std::size_t at = 0; at < WidePacketEights::most; at += hn::Lanes(tag))
    greatest = hn::Max(greatest, hn::LoadU(tag, &eights.limit[at]));
  return hn::GetLane(hn::MaxOfLanes(tag, greatest));
}

/// The groups of eight of which some ray may meet the box of a child, a bit each.
HWY_INLINE unsigned met_eights(const WideNode& node, std::size_t child, const WidePacketEights& eights) {
  const Tag tag;
  const auto plane = [&](std::size_t which) HWY_ATTR { return hn::Set(tag, double{node.planes[which][child]}); };
  unsigned met = 0;
  for (std::size_t at = 0; at < WidePacketEights::most; at += hn::Lanes(tag)) {
    Lanes entry = hn::Zero(tag), exit = hn::LoadU(tag, &eights.limit[at]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool backwards = eights.inverse_high[axis][0] < 0;
      const auto& p_near = backwards ? eights.p_low[axis] : eights.p_high[axis];
      const auto& p_far = backwards ? eights.p_high[axis] : eights.p_low[axis];
      const Lanes a = hn::LoadU(tag, &eights.inverse_low[axis][at]), b = hn::LoadU(tag, &eights.inverse_high[axis][at]);
      const Lanes near = hn::Sub(plane(backwards ? axis + 3 : axis), hn::LoadU(tag, &p_near[at]));
      const Lanes far = hn::Sub(plane(backwards ? axis : axis + 3), hn::LoadU(tag, &p_far[at]));
      entry = later(entry, hn::Min(hn::Mul(near, a), hn::Mul(near, b)));
      exit = sooner(exit, hn::Max(hn::Mul(far, a), hn::Mul(far, b)));
    }
    met |= bits(meets(entry, exit)) << at;
  }
  return met;
}

std::uint64_t met_by_eights(const WideNode& node, std::size_t child, const WidePacket& bundle,
                            const WidePacketEights& eights) {
  const LaneBox box(node, child, bundle);
  std::uint64_t met = 0;
  for (unsigned left = met_eights(node, child, eights); left != 0; left &= left - 1) {
    const std::size_t begin = WidePacket::eight * static_cast<std::size_t>(std::countr_zero(left));
    for (std::size_t at = begin; at < begin + WidePacket::eight; at += hn::Lanes(Tag()))
      met |= std::uint64_t{box.met_from(bundle, at)} << at;
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
HWY_EXPORT(gather_eights);
HWY_EXPORT(bring_eights_up_to_date);
HWY_EXPORT(met_by_eights);
}  // namespace

void gather(WidePacketEights& eights, const WidePacket& bundle) { HWY_DYNAMIC_DISPATCH(gather_eights)(eights, bundle); }
double bring_up_to_date(WidePacketEights& eights, const WidePacket& bundle, std::uint64_t which) {
  return HWY_DYNAMIC_DISPATCH(bring_eights_up_to_date)(eights, bundle, which);
}
std::uint64_t met_by(const WideNode& node, std::size_t child, const WidePacket& bundle,
                     const WidePacketEights& eights) {
  return HWY_DYNAMIC_DISPATCH(met_by_eights)(node, child, bundle, eights);
}

}  // namespace durero::accel
#endif
