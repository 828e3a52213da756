#define HWY_TARGET_INCLUDE "accel/wide/stream_traversal.cpp"  // as seen from src/
#include "lanes/for_each_target.hpp"
//
#include <bit>
#include <cmath>

#include "accel/wide/wide_lanes-inl.hpp"
#include "durero/accel/wide/stream_traversal.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::accel {
namespace HWY_NAMESPACE {
namespace {

/// The near and far planes of the children from `at` on, by axis, for rays with the signs of `beam`.
struct LanePlanes {
  HWY_INLINE LanePlanes(const WideNode& node, const Beam& beam, std::size_t at) {
    const auto of = [&](int axis, bool high) HWY_ATTR {
      return planes(node, static_cast<std::size_t>(axis) + (high != std::signbit(beam.inverse[axis]) ? 3 : 0), at);
    };
    near_x = of(0, false), near_y = of(1, false), near_z = of(2, false);
    far_x = of(0, true), far_y = of(1, true), far_z = of(2, true);
  }
  Lanes near_x, near_y, near_z, far_x, far_y, far_z;
};

HWY_INLINE Lanes crossing(Lanes plane, double p, double inverse) {
  return hn::Mul(hn::Sub(plane, hn::Set(Tag(), p)), hn::Set(Tag(), inverse));
}

void meet_in_lanes(const WideNode& node, std::span<const StreamRay> rays, std::span<const std::uint32_t> some,
                   StreamPairs& met) {
  const Tag tag;
  const hn::Rebind<std::uint64_t, Tag> tag_of_whose;
  double* const entries = met.entries.data();
  std::uint64_t* const whose_met = met.whose.data();
  std::size_t size = 0;
  for (std::size_t at = 0; at < WideNode::width; at += hn::Lanes(tag)) {
    const LanePlanes plane(node, rays[some[0]].beam, at);
    const auto places = hn::ShiftLeft<32>(hn::Iota(tag_of_whose, at));
    auto count = hn::Zero(tag_of_whose);
    Lanes soonest = hn::Set(tag, HUGE_VAL);
    for (const std::uint32_t i : some) {
      const auto& [p, inverse] = rays[i].beam;
      Lanes entry = later(hn::Zero(tag), crossing(plane.near_x, p.x, inverse.x));
      entry = later(entry, crossing(plane.near_y, p.y, inverse.y));
      entry = later(entry, crossing(plane.near_z, p.z, inverse.z));
      Lanes exit = sooner(hn::Set(tag, rays[i].limit), crossing(plane.far_x, p.x, inverse.x));
      exit = sooner(exit, crossing(plane.far_y, p.y, inverse.y));
      exit = sooner(exit, crossing(plane.far_z, p.z, inverse.z));
      const auto is_met = meets(entry, exit);
      count = hn::Add(count, hn::IfThenElseZero(hn::RebindMask(tag_of_whose, is_met), hn::Set(tag_of_whose, 1)));
      soonest = hn::Min(soonest, hn::IfThenElse(is_met, entry, hn::Set(tag, HUGE_VAL)));
      const unsigned met_places = bits(is_met);
      const auto order = in_front(met_places);
      hn::StoreU(hn::TableLookupLanes(entry, order), tag, entries + size);
      const auto whose = hn::BitCast(tag, hn::Or(places, hn::Set(tag_of_whose, i)));
      hn::StoreU(hn::BitCast(tag_of_whose, hn::TableLookupLanes(whose, order)), tag_of_whose, whose_met + size);
      size += static_cast<std::size_t>(std::popcount(met_places));
    }
    hn::StoreU(count, tag_of_whose, &met.count[at]);
    hn::StoreU(soonest, tag, &met.soonest[at]);
  }
  met.size = size;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::accel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::accel {
namespace {
HWY_EXPORT(meet_in_lanes);
}  // namespace

/// The columns have room for one ray more, because a store fills whole lanes.
void meet(const WideNode& node, std::span<const StreamRay> rays, std::span<const std::uint32_t> some,
          StreamPairs& met) {
  met.size = 0;
  met.count.fill(0);
  met.soonest.fill(HUGE_VAL);
  const std::size_t room = WideNode::width * (some.size() + 1);
  if (met.entries.size() < room) met.entries.resize(room), met.whose.resize(room);
  if (!some.empty()) HWY_DYNAMIC_DISPATCH(meet_in_lanes)(node, rays, some, met);
}

}  // namespace durero::accel
#endif
