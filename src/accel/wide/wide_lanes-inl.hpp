/// The operations of the box test (durero/accel/slab.hpp) in lanes.

#if defined(DURERO_ACCEL_WIDE_LANES_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_ACCEL_WIDE_LANES_INL_HPP_
#undef DURERO_ACCEL_WIDE_LANES_INL_HPP_
#else
#define DURERO_ACCEL_WIDE_LANES_INL_HPP_
#endif

#include <hwy/highway.h>

#include <array>
#include <cstdint>

#include "durero/accel/wide/wide_node.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::accel {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, WideNode::width>;
using HalfTag = hn::Rebind<float, Tag>;
using Lanes = hn::Vec<Tag>;

/// The planes of that index of the children from `at` on, widened exactly to binary64.
HWY_INLINE Lanes planes(const WideNode& node, std::size_t plane, std::size_t at) {
  return hn::PromoteTo(Tag(), hn::LoadU(HalfTag(), &node.planes[plane][at]));
}

/// The later of two entries and the sooner of two exits; the first argument where the second is NaN. On x86 the max and
/// min instructions answer this when their operands are swapped.
#if HWY_ARCH_X86
HWY_INLINE Lanes later(Lanes entry, Lanes near) { return hn::Max(near, entry); }
HWY_INLINE Lanes sooner(Lanes exit, Lanes far) { return hn::Min(far, exit); }
#else
HWY_INLINE Lanes later(Lanes entry, Lanes near) { return hn::IfThenElse(hn::Lt(entry, near), near, entry); }
HWY_INLINE Lanes sooner(Lanes exit, Lanes far) { return hn::IfThenElse(hn::Lt(far, exit), far, exit); }
#endif

/// BoxInterval::meets in lanes.
HWY_INLINE hn::Mask<Tag> meets(Lanes entry, Lanes exit) {
  const Tag tag;
  return hn::Le(entry, hn::Add(hn::Mul(exit, hn::Set(tag, grow)), hn::Set(tag, tiny)));
}

HWY_INLINE unsigned bits(hn::Mask<Tag> mask) {
  std::uint8_t stored[8] = {};
  hn::StoreMaskBits(Tag(), mask, stored);
  return stored[0];
}

/// The box of a child in every lane, its near and far planes chosen by the signs of a bundle's directions.
struct LaneBox {
  HWY_INLINE LaneBox(const WideNode& node, std::size_t child, const WidePacket& bundle) {
    const auto plane = [&](std::size_t which) HWY_ATTR { return hn::Set(Tag(), double{node.planes[which][child]}); };
    const auto first = [&](std::size_t axis) { return bundle.inverse_high[axis] < 0 ? axis + 3 : axis; };
    const std::size_t x_first = first(0), y_first = first(1), z_first = first(2);
    near_x = plane(x_first), near_y = plane(y_first), near_z = plane(z_first);
    far_x = plane(3 - x_first), far_y = plane(5 - y_first), far_z = plane(7 - z_first);
  }
  /// The rays that may meet the box, a bit each, of those from `at` on that fill the lanes.
  HWY_INLINE unsigned met_from(const WidePacket& bundle, std::size_t at) const {
    const Tag tag;
    const auto& p = bundle.rays.p;
    const auto& inverse = bundle.inverse;
    const Lanes x = hn::LoadU(tag, &p[0][at]), ix = hn::LoadU(tag, &inverse[0][at]);
    const Lanes y = hn::LoadU(tag, &p[1][at]), iy = hn::LoadU(tag, &inverse[1][at]);
    const Lanes z = hn::LoadU(tag, &p[2][at]), iz = hn::LoadU(tag, &inverse[2][at]);
    Lanes entry = later(hn::Zero(tag), hn::Mul(hn::Sub(near_x, x), ix));
    entry = later(entry, hn::Mul(hn::Sub(near_y, y), iy));
    entry = later(entry, hn::Mul(hn::Sub(near_z, z), iz));
    Lanes exit = sooner(hn::LoadU(tag, &bundle.limit[at]), hn::Mul(hn::Sub(far_x, x), ix));
    exit = sooner(exit, hn::Mul(hn::Sub(far_y, y), iy));
    exit = sooner(exit, hn::Mul(hn::Sub(far_z, z), iz));
    return bits(meets(entry, exit));
  }
  Lanes near_x, near_y, near_z, far_x, far_y, far_z;
};

/// For each set of lanes, the indices of its members in ascending order, the first lowest, in four bits each.
/// (Highway's Compress copies its table at every call.)
inline constexpr std::array<std::uint64_t, 256> first_places = [] {
  std::array<std::uint64_t, 256> packed{};
  for (std::size_t set = 0; set < packed.size(); ++set) {
    unsigned shift = 0;
    for (std::uint64_t place = 0; place < 8; ++place) {
      if ((set >> place & 1) == 0) continue;
      packed[set] |= place << shift;
      shift += 4;
    }
  }
  return packed;
}();

/// A permutation that moves the lanes of a set to the front, in their order.
HWY_INLINE auto in_front(unsigned set) {
  const hn::Rebind<std::uint64_t, Tag> tag;
  const auto shifts = hn::ShiftLeft<2>(hn::Iota(tag, 0));
  return hn::IndicesFromVec(Tag(), hn::And(hn::Shr(hn::Set(tag, first_places[set]), shifts), hn::Set(tag, 7)));
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::accel
HWY_AFTER_NAMESPACE();

#endif
