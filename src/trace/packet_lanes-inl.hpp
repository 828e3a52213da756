/// Loads the columns of a packet into lanes.

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

template <class Column>
HWY_INLINE Vec<Lanes> load(const std::array<Column, 3>& columns, std::size_t at) {
  return {Lanes::load(&columns[0][at]), Lanes::load(&columns[1][at]), Lanes::load(&columns[2][at])};
}

/// The rays from lane `at` on.
HWY_INLINE LaneRay rays(const Packet& packet, std::size_t at) {
  return {load(packet.p, at), load(packet.v, at), Lanes::load(&packet.speed[at])};
}

/// The elements from lane `at` on.
template <model::Tipo tipo>
HWY_INLINE LaneElement<tipo> element(const Packet& packet, std::size_t at) {
  return {load(packet.centro, at),
          Lanes::load(&packet.radio[at]),
          Lanes::load(&packet.proporcion[at]),
          load(packet.vector, at),
          Lanes::load(&packet.altura[at]),
          {load(packet.vertices[0], at), load(packet.vertices[1], at), load(packet.vertices[2], at)}};
}

/// Triangles in columns of binary32, from place `at` on, widened exactly.
template <class Column>
HWY_INLINE LaneElement<model::Tipo::soy_triangulo> widened_triangles(
    const std::array<std::array<Column, 3>, 3>& vertices, std::size_t at) {
  const hn::Rebind<float, LaneTag> half;
  LaneElement<model::Tipo::soy_triangulo> element{};
  const auto of = [&](std::size_t i, std::size_t axis)
                      HWY_ATTR { return Lanes(hn::PromoteTo(LaneTag(), hn::LoadU(half, &vertices[i][axis][at]))); };
  for (std::size_t i = 0; i < 3; ++i) element.vertices[i] = {of(i, 0), of(i, 1), of(i, 2)};
  return element;
}

/// A vector in every lane.
HWY_INLINE Vec<Lanes> in_every_lane(const glm::dvec3& x) { return {Lanes(x.x), Lanes(x.y), Lanes(x.z)}; }

/// An element in every lane.
template <class Shape>
HWY_INLINE LaneElement<Shape::tipo> in_every_lane(const Shape& shape) {
  LaneElement<Shape::tipo> element{};
  if constexpr (requires { shape.centro; }) element.centro = in_every_lane(shape.centro);
  if constexpr (requires { shape.radio; }) element.radio = Lanes(shape.radio);
  if constexpr (requires { shape.proporcion; }) element.proporcion = Lanes(shape.proporcion);
  if constexpr (requires { shape.vector; }) element.vector = in_every_lane(shape.vector);
  if constexpr (requires { shape.altura; }) element.altura = Lanes(shape.altura);
  if constexpr (requires { shape.vertices; })
    for (std::size_t i = 0; i < element.vertices.size(); ++i) element.vertices[i] = in_every_lane(shape.vertices[i]);
  return element;
}

}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#endif
