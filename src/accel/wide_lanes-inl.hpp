/// The operations of the box test (durero/accel/slab.hpp) in lanes.

#if defined(DURERO_ACCEL_WIDE_LANES_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_ACCEL_WIDE_LANES_INL_HPP_
#undef DURERO_ACCEL_WIDE_LANES_INL_HPP_
#else
#define DURERO_ACCEL_WIDE_LANES_INL_HPP_
#endif

#include <hwy/highway.h>

#include "durero/accel/wide_node.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::accel {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, WideNode::width>;
using HalfTag = hn::Rebind<float, Tag>;
using Lanes = hn::Vec<Tag>;

/// The planes of the children from one on, exactly.
HWY_INLINE Lanes planes(const WideNode& node, std::size_t plane, std::size_t at) {
  return hn::PromoteTo(Tag(), hn::LoadU(HalfTag(), &node.planes[plane][at]));
}

/// The latest of two entries, the soonest of two exits: the first where the second is NaN. On x86 that is what the
/// instruction answers whose second operand comes first here.
#if HWY_ARCH_X86
HWY_INLINE Lanes later(Lanes entry, Lanes near) { return hn::Max(near, entry); }
HWY_INLINE Lanes sooner(Lanes exit, Lanes far) { return hn::Min(far, exit); }
#else
HWY_INLINE Lanes later(Lanes entry, Lanes near) { return hn::IfThenElse(hn::Lt(entry, near), near, entry); }
HWY_INLINE Lanes sooner(Lanes exit, Lanes far) { return hn::IfThenElse(hn::Lt(far, exit), far, exit); }
#endif

/// As Stretch::meets.
HWY_INLINE hn::Mask<Tag> meets(Lanes entry, Lanes exit) {
  const Tag tag;
  return hn::Le(entry, hn::Add(hn::Mul(exit, hn::Set(tag, grow)), hn::Set(tag, tiny)));
}

HWY_INLINE unsigned bits(hn::Mask<Tag> mask) {
  std::uint8_t stored[8] = {};
  hn::StoreMaskBits(Tag(), mask, stored);
  return stored[0];
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::accel
HWY_AFTER_NAMESPACE();

#endif
