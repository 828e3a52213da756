/// The columns of a pack, in lanes.

#if defined(DURERO_TRACE_PACK_LANES_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_PACK_LANES_INL_HPP_
#undef DURERO_TRACE_PACK_LANES_INL_HPP_
#else
#define DURERO_TRACE_PACK_LANES_INL_HPP_
#endif

#include "durero/trace/numbers-inl.hpp"
#include "durero/trace/pack.hpp"
#include "durero/trace/quadratic-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

HWY_INLINE Vec<Lanes> load(const Pack::Columns& columns, std::size_t at) {
  return {Lanes::load(&columns[0][at]), Lanes::load(&columns[1][at]), Lanes::load(&columns[2][at])};
}

/// The rays from lane `at` on.
HWY_INLINE LaneBeam beam(const Pack& pack, std::size_t at) {
  return {load(pack.p, at), load(pack.v, at), Lanes::load(&pack.speed[at])};
}

/// Their elements.
template <model::Tipo type>
HWY_INLINE LaneElement<type> element(const Pack& pack, std::size_t at) {
  const Lanes breadth = Lanes::load(&pack.breadth[at]);
  return {load(pack.centro, at), breadth, breadth, load(pack.vector, at), Lanes::load(&pack.altura[at])};
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
