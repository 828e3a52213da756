/// Several binary64 in a register, with the operators of one. An algorithm over a number type T computes for T = Lanes,
/// in each lane, the bits that it computes for T = double.

#if defined(DURERO_TRACE_LANES_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_LANES_INL_HPP_
#undef DURERO_TRACE_LANES_INL_HPP_
#else
#define DURERO_TRACE_LANES_INL_HPP_
#endif

#include <hwy/highway.h>

#include <cmath>
#include <cstdint>

#include "durero/trace/packet.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using LaneTag = hn::CappedTag<double, Packet::size>;

/// The result of comparing lanes, as a bool is of comparing numbers.
struct LaneMask {
  hn::Mask<LaneTag> m;

  friend HWY_INLINE LaneMask operator&(LaneMask a, LaneMask b) { return {hn::And(a.m, b.m)}; }
  friend HWY_INLINE LaneMask operator|(LaneMask a, LaneMask b) { return {hn::Or(a.m, b.m)}; }
  friend HWY_INLINE LaneMask operator!(LaneMask a) { return {hn::Not(a.m)}; }
  friend HWY_INLINE LaneMask operator==(LaneMask a, LaneMask b) { return {hn::Not(hn::Xor(a.m, b.m))}; }
};

struct Lanes {
  hn::Vec<LaneTag> v;

  Lanes() = default;
  HWY_INLINE Lanes(hn::Vec<LaneTag> value) : v(value) {}
  HWY_INLINE Lanes(double value) : v(hn::Set(LaneTag(), value)) {}

  static HWY_INLINE Lanes load(const double* from) { return hn::Load(LaneTag(), from); }
  HWY_INLINE void store(double* to) const { hn::Store(v, LaneTag(), to); }

  friend HWY_INLINE Lanes operator+(Lanes a, Lanes b) { return hn::Add(a.v, b.v); }
  friend HWY_INLINE Lanes operator-(Lanes a, Lanes b) { return hn::Sub(a.v, b.v); }
  friend HWY_INLINE Lanes operator*(Lanes a, Lanes b) { return hn::Mul(a.v, b.v); }
  friend HWY_INLINE Lanes operator/(Lanes a, Lanes b) { return hn::Div(a.v, b.v); }
  friend HWY_INLINE Lanes operator-(Lanes a) { return hn::Neg(a.v); }
  friend HWY_INLINE LaneMask operator<(Lanes a, Lanes b) { return {hn::Lt(a.v, b.v)}; }
  friend HWY_INLINE LaneMask operator>(Lanes a, Lanes b) { return {hn::Gt(a.v, b.v)}; }
  friend HWY_INLINE LaneMask operator<=(Lanes a, Lanes b) { return {hn::Le(a.v, b.v)}; }
  friend HWY_INLINE LaneMask operator>=(Lanes a, Lanes b) { return {hn::Ge(a.v, b.v)}; }
  friend HWY_INLINE LaneMask operator==(Lanes a, Lanes b) { return {hn::Eq(a.v, b.v)}; }
  friend HWY_INLINE Lanes abs(Lanes a) { return hn::Abs(a.v); }
  friend HWY_INLINE Lanes sqrt(Lanes a) { return hn::Sqrt(a.v); }
};

/// Selects yes where the condition holds, no elsewhere.
HWY_INLINE Lanes choose(LaneMask condition, Lanes yes, Lanes no) { return hn::IfThenElse(condition.m, yes.v, no.v); }
template <class T>
HWY_INLINE T choose(bool condition, const T& yes, const T& no) {
  return condition ? yes : no;
}

/// The lanes of a mask as bits, the first lane lowest.
HWY_INLINE unsigned bits(LaneMask mask) {
  std::uint8_t stored[8] = {};
  hn::StoreMaskBits(LaneTag(), mask.m, stored);
  return stored[0];
}

/// The number of lanes of a register: 8, 4, 2 or 1 of the numbers of a packet.
HWY_INLINE std::size_t lanes() { return hn::Lanes(LaneTag()); }

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
