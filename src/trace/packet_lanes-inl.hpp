/// The columns of a packet, in lanes.

#if defined(DURERO_TRACE_PACKET_LANES_INL_HPP_) == defined(HWY_TARGET_TOGGLE)
#ifdef DURERO_TRACE_PACKET_LANES_INL_HPP_
#undef DURERO_TRACE_PACKET_LANES_INL_HPP_
#else
#define DURERO_TRACE_PACKET_LANES_INL_HPP_
#endif

#include "durero/trace/packet.hpp"
#include "trace/numbers-inl.hpp"
#include "trace/quadratic-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {

HWY_INLINE Vec<Lanes> load(const Packet::Columns& columns, std::size_t at) {
  return {Lanes::load(&columns[0][at]), Lanes::load(&columns[1][at]), Lanes::load(&columns[2][at])};
}

/// The rays from lane `at` on.
HWY_INLINE LaneRay rays(const Packet& packet, std::size_t at) {
  return {load(packet.p, at), load(packet.v, at), Lanes::load(&packet.speed[at])};
}

/// Their elements.
template <model::Tipo tipo>
HWY_INLINE LaneElement<tipo> element(const Packet& packet, std::size_t at) {
  return {load(packet.centro, at),
          Lanes::load(&packet.radio[at]),
          Lanes::load(&packet.proporcion[at]),
          load(packet.vector, at),
          Lanes::load(&packet.altura[at]),
          {load(packet.vertices[0], at), load(packet.vertices[1], at), load(packet.vertices[2], at)}};
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
