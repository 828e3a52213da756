#pragma once
/// Shapes that are turned around an axis, as their profile: the half of a section through the axis.
///
/// Let d be the stored axis, q = p − centro, s = q·d and dd = d·d. All that the text says of such a shape depends on
/// the advance of a point and on its distance from the line of the axis alone, be dd 1 or not: with e = q − (s/dd)·d
/// alejamiento is |e|² + s²·(1 − dd)²/dd. So at the advance s the shape has a ring, whose squared radius times dd is
///   H(s) = dd·(a − k·s)² − (1 − dd)²·s²,   0 ≤ s ≤ altura and H(s) ≥ 0,
/// with the radius a at the centre and k less for each unit of advance. A cylinder has k = 0, a cone a = k·altura.

#include "durero/algebra/root.hpp"
#include "durero/distance/exact.hpp"
#include "durero/number/dyadic_surd.hpp"

namespace durero::distance::exact {

using algebra::Polynomial;
using algebra::Value;
using number::Dyadic;
using number::DyadicSurd;
using number::shifted;
using number::sign;
using number::square;

/// A vector of dyadic numbers.
using Triple = std::array<Dyadic, 3>;

inline Triple triple(const glm::dvec3& v) { return {Dyadic(v.x), Dyadic(v.y), Dyadic(v.z)}; }
inline Dyadic dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Triple difference(const Triple& a, const Triple& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// A point, as it stands to the axis of a shape.
struct AxialPoint {
  Triple centro, d;
  Dyadic dd, s;          ///< d·d, and the advance of the point
  Triple out;            ///< dd·e, from the axis to the point
  Dyadic squared_out{};  ///< dd·|e|², that is dd·|q|² − s²

  AxialPoint(const glm::dvec3& centro, const glm::dvec3& vector, const glm::dvec3& p);
};

/// A ring about the axis at the advance s, whose squared radius times dd is H ≥ 0.
Nearest of_ring(const AxialPoint& seen, const Dyadic& s, const Dyadic& H);

/// The rings 0 ≤ s ≤ altura of the radius a − k·s, as above. Precondition: a > 0 and k ≥ 0.
struct RingProfile {
  Dyadic a, k, altura;
};
Nearest of_profile(const AxialPoint& seen, const RingProfile& profile);

}  // namespace durero::distance::exact
