#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "accel/wide_node.cpp"  // as seen from src/
#include <hwy/foreach_target.h>
//
#include "accel/wide_lanes-inl.hpp"
//
#include "durero/accel/wide_node.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::accel {
namespace HWY_NAMESPACE {
namespace {

unsigned met_by_bundle(const WideNode& node, const WideBundle& bundle, double limit, WideNode::Entries& entries) {
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

std::uint64_t met_by_each(const WideNode& node, std::size_t child, const WideBundle& bundle) {
  const Tag tag;
  std::uint64_t met = 0;
  for (std::size_t at = 0; at < bundle.count; at += hn::Lanes(tag)) {
    Lanes entry = hn::Zero(tag), exit = hn::LoadU(tag, &bundle.limit[at]);
    for (std::size_t low = 0; low < 3; ++low) {
      const std::size_t high = low + 3;
      const bool backwards = bundle.inverse_high[low] < 0;
      const Lanes near = hn::Set(tag, static_cast<double>(node.planes[backwards ? high : low][child]));
      const Lanes far = hn::Set(tag, static_cast<double>(node.planes[backwards ? low : high][child]));
      const Lanes p = hn::LoadU(tag, &bundle.p[low][at]), inverse = hn::LoadU(tag, &bundle.inverse[low][at]);
      entry = later(entry, hn::Mul(hn::Sub(near, p), inverse));
      exit = sooner(exit, hn::Mul(hn::Sub(far, p), inverse));
    }
    met |= std::uint64_t{bits(meets(entry, exit))} << at;
  }
  return met & (~std::uint64_t{0} >> (WideBundle::size - bundle.count));
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::accel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::accel {
namespace {
HWY_EXPORT(met_by_bundle);
HWY_EXPORT(met_by_each);
}  // namespace

unsigned met(const WideNode& node, const WideBundle& bundle, double limit, WideNode::Entries& entries) {
  return HWY_DYNAMIC_DISPATCH(met_by_bundle)(node, bundle, limit, entries);
}
std::uint64_t met_by(const WideNode& node, std::size_t child, const WideBundle& bundle) {
  return HWY_DYNAMIC_DISPATCH(met_by_each)(node, child, bundle);
}

}  // namespace durero::accel
#endif
