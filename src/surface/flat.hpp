#pragma once
/// The crossing of a line and the plane of a flat element, over any numbers: Dyadics, or balls that contain exact
/// numbers.

#include <array>

#include "durero/surface/surfaces.hpp"

namespace durero::surface::exact {

/// potencia along the line, and margins, none of which is negative where the line crosses the plane on the element or
/// its edge. The margins mean nothing where the slope is 0 and the line does not cross the plane.
template <class N, std::size_t count>
struct FlatCrossing {
  Linear<N> potencia;
  std::array<N, count> margins;
};

template <class N>
FlatCrossing<N, 0> crossing(const scene::Plane& plane, const model::Rayo& rayo) {
  return {potencia(plane, along<N>(rayo)), {}};
}

/// The crossing is at t = −at_zero/slope. With w its vector from the centre, |slope|·|w| = |slope·q − at_zero·v|.
template <class N>
FlatCrossing<N, 1> crossing(const scene::Disc& disc, const model::Rayo& rayo) {
  const auto w = along<N>(rayo);
  const Point<Linear<N>> q = from(disc.centro, w);
  const Linear<N> s = potencia(disc, w);
  const auto out = [&](const Linear<N>& x) { return x.at_zero * s.slope - x.slope * s.at_zero; };
  return {s, {square(N(disc.radio) * s.slope) - squared_length(Point<N>{out(q.x), out(q.y), out(q.z)})}};
}

template <class N>
N dot(const Point<N>& a, const Point<N>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class N>
Point<N> cross(const Point<N>& a, const Point<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A line and the edges e1 = b − a and e2 = c − a of a triangle, with q = p − a.
template <class N>
struct LineOverEdges {
  Point<N> e1, e2, q, v;
};
template <class N>
LineOverEdges<N> over_edges(const scene::Triangle& triangle, const model::Rayo& rayo) {
  const auto& [a, b, c] = triangle.vertices;
  const glm::dvec3& v = rayo.v().xyz();
  return {between<N>(a, b), between<N>(a, c), between<N>(a, rayo.p().xyz()), {N(v.x), N(v.y), N(v.z)}};
}

/// With det = e1·(v × e2) = −v·(e1 × e2), the line crosses the plane where t·det = e2·(q × e1), which is the potencia
/// of its origin. There the lados of ca and ab are (e1 × e2)²/det times q·(v × e2) and v·(q × e1), and the three add up
/// to (e1 × e2)². The margins are these numbers with the sign of det.
template <class N>
FlatCrossing<N, 3> crossing(const scene::Triangle& triangle, const model::Rayo& rayo) {
  const auto [e1, e2, q, v] = over_edges<N>(triangle, rayo);
  const Point<N> v_e2 = cross(v, e2), q_e1 = cross(q, e1);
  const N det = dot(e1, v_e2), ca = dot(q, v_e2), ab = dot(v, q_e1), bc = det - ca - ab;
  const auto of = [&](const N& lado) { return sign(det) < 0 ? -lado : lado; };
  return {{dot(e2, q_e1), -det}, {of(ab), of(bc), of(ca)}};
}

}  // namespace durero::surface::exact
