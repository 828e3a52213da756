#define HWY_TARGET_INCLUDE "accel/wide/wide_node.cpp"  // as seen from src/
#include "lanes/for_each_target.hpp"
//
#include <bit>

#include "accel/wide/wide_lanes-inl.hpp"
#include "durero/accel/wide/wide_node.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::accel {
namespace HWY_NAMESPACE {
namespace {

void invert_lanes(WidePacket& bundle, std::size_t count) {
  const Tag tag;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t at = 0; at < count; at += hn::Lanes(tag))
      hn::StoreU(hn::Div(hn::Set(tag, 1), hn::LoadU(tag, &bundle.rays.v[axis][at])), tag, &bundle.inverse[axis][at]);
}

/// The range of a column, over the places that traverse.
HWY_INLINE void enclose(const WidePacket& bundle, const WidePacket::Column& column, double& low, double& high) {
  const Tag tag;
  Lanes least = hn::LoadU(tag, &column[bundle.begin]), greatest = least;
  for (std::size_t at = bundle.begin; at < bundle.end; at += hn::Lanes(tag)) {
    const Lanes some = hn::LoadU(tag, &column[at]);
    least = hn::Min(least, some);
    greatest = hn::Max(greatest, some);
  }
  low = hn::GetLane(hn::MinOfLanes(tag, least));
  high = hn::GetLane(hn::MaxOfLanes(tag, greatest));
}

bool gather_lanes(WidePacket& bundle, std::size_t begin, std::size_t end) {
  bundle.begin = begin, bundle.end = end;
  bool together = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double &low = bundle.inverse_low[axis], &high = bundle.inverse_high[axis];
    enclose(bundle, bundle.inverse[axis], low, high);
    together &= (low < 0) == (high < 0) && !std::isinf(low) && !std::isinf(high);
  }
  if (!together) return false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    enclose(bundle, bundle.rays.p[axis], bundle.p_low[axis], bundle.p_high[axis]);
    enclose(bundle, bundle.rays.v[axis], bundle.v_low[axis], bundle.v_high[axis]);
  }
  return true;
}

double farthest_lane(const WidePacket& bundle) {
  const Tag tag;
  Lanes farthest = hn::Zero(tag);
  for (std::size_t at = bundle.begin; at < bundle.end; at += hn::Lanes(tag))
    farthest = hn::Max(farthest, hn::LoadU(tag, &bundle.limit[at]));
  return hn::GetLane(hn::MaxOfLanes(tag, farthest));
}

unsigned met_by_bundle(const WideNode& node, const WidePacket& bundle, double limit, WideNode::Entries& entries) {
  const Tag tag;
  unsigned met = 0;
  for (std::size_t at = 0; at < WideNode::width; at += hn::Lanes(tag)) {
    Lanes entry = hn::Zero(tag), exit = hn::Set(tag, limit);
    for (std::size_t low = 0; low < 3; ++low) {
      const std::size_t high = low + 3;
      const bool backwards = bundle.inverse_high[low] < 0;
      const Lanes p_low = hn::Set(tag, bundle.p_low[low]), p_high = hn::Set(tag, bundle.p_high[low]);
      const Lanes a = hn::Set(tag, bundle.inverse_low[low]), b = hn::Set(tag, bundle.inverse_high[low]);
      const Lanes near = hn::Sub(planes(node, backwards ? high : low, at), backwards ? p_low : p_high);
      const Lanes far = hn::Sub(planes(node, backwards ? low : high, at), backwards ? p_high : p_low);
      entry = later(entry, hn::Min(hn::Mul(near, a), hn::Mul(near, b)));
      exit = sooner(exit, hn::Max(hn::Mul(far, a), hn::Mul(far, b)));
    }
    hn::StoreU(entry, tag, &entries[at]);
    met |= bits(meets(entry, exit)) << at;
  }
  return met;
}

/// Children are tested one after another, so that the bits of one gather in a register. Most often few are asked about.
void met_by_each(const WideNode& node, unsigned children, const WidePacket& bundle, WideMeetings& met) {
  for (unsigned left = children; left != 0; left &= left - 1) {
    const auto child = static_cast<std::size_t>(std::countr_zero(left));
    const LaneBox box(node, child, bundle);
    std::uint64_t of_child = 0;
    for (std::size_t at = bundle.begin; at < bundle.end; at += hn::Lanes(Tag()))
      of_child |= std::uint64_t{box.met_from(bundle, at)} << at;
    met[child] = of_child;
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::accel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::accel {
namespace {
HWY_EXPORT(invert_lanes);
HWY_EXPORT(gather_lanes);
HWY_EXPORT(farthest_lane);
HWY_EXPORT(met_by_bundle);
HWY_EXPORT(met_by_each);
}  // namespace

void invert(WidePacket& bundle, std::size_t count) { HWY_DYNAMIC_DISPATCH(invert_lanes)(bundle, count); }
bool gather(WidePacket& bundle, std::size_t begin, std::size_t end) {
  return HWY_DYNAMIC_DISPATCH(gather_lanes)(bundle, begin, end);
}
double farthest(const WidePacket& bundle) { return HWY_DYNAMIC_DISPATCH(farthest_lane)(bundle); }
unsigned met(const WideNode& node, const WidePacket& bundle, double limit, WideNode::Entries& entries) {
  return HWY_DYNAMIC_DISPATCH(met_by_bundle)(node, bundle, limit, entries);
}
void met_by(const WideNode& node, unsigned children, const WidePacket& bundle, WideMeetings& met) {
  HWY_DYNAMIC_DISPATCH(met_by_each)(node, children, bundle, met);
}

}  // namespace durero::accel
#endif
