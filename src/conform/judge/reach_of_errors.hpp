#pragma once
/// The h·δ of an element: each point of the element of some data within the allowance is so near a point of the element
/// given, and the other way round.

#include <cmath>
#include <limits>
#include <optional>

#include "conform/ask/asked_elements.hpp"

namespace durero::conform {

/// @{ The h·δ of a shape; nothing where errors may leave nothing of it.
/// The centre of a sphere is off by √3·δ, and the radius by δ: 2.74·δ.
inline std::optional<Dyadic> reach_of_errors(const scene::Sphere&, const Allowance& allowed) {
  return allowed.times(3);
}
/// Each point of a triangle is off as its vertices, by √3·δ.
inline std::optional<Dyadic> reach_of_errors(const scene::Triangle&, const Allowance& allowed) {
  return allowed.times(2);
}
/// A plane's distance is |q·d| with q = p − centro: q off by √3·δ for centro alone, and |q|·√3·u ≤ 6·δ for d.
inline std::optional<Dyadic> reach_of_errors(const scene::Plane&, const Allowance& allowed) { return allowed.times(8); }
/// The centre of a disc is off by √3·δ, the radius by δ, and the rim by radio·√3·u ≤ √3·δ for its vector: 4.5·δ.
inline std::optional<Dyadic> reach_of_errors(const scene::Disc&, const Allowance& allowed) { return allowed.times(5); }
/// A point of a shape with an axis is centro + s·d + R(s)·n with n across d. centro is off by √3·δ, s·d by √3·δ for d
/// and by δ for altura, n by √3·u for d, and R(s) by (2 + k + g)·δ, as that of shell.hpp: (8.2 + k + g)·δ. Where d·d is
/// not 1 the ring at the advance s has the squared radius R(s)² − w² times 1/(d·d), with w = |1 − d·d|·s < 4·δ: it is
/// smaller by less than 4·δ, and there is none where R(s) < w. Where the shape narrows to less than 4·δ, it may lose as
/// much of its end as has such radii, 4·δ/k; a cylinder so thin may be lost.
template <surface::Axial Shape>
std::optional<Dyadic> reach_of_errors(const Shape& shape, const Allowance& allowed) {
  const double narrowing = proportion(shape);
  const Dyadic k(narrowing), thin = allowed.times(4), least = radius_at_centre(shape) - k * Dyadic(shape.altura);
  const Dyadic reach = allowed.times(Dyadic(13) + k + allowed.u * k);
  if (least >= thin) return reach;
  const double lost = std::nextafter(1 / narrowing, std::numeric_limits<double>::infinity());
  return std::isfinite(lost) ? std::optional(reach + thin * Dyadic(lost)) : std::nullopt;
}
/// A disc that closes a solid is off by the errors of its wall: its centre and its rim by no more than points of the
/// wall, and by δ for roundings where the solid ends.
inline std::optional<Dyadic> reach_of_errors(const DiscOfSolid& e, const Allowance& allowed) {
  const Dyadic k(e.proporcion);
  return allowed.times(Dyadic(10) + k + allowed.u * k);
}
/// @}

}  // namespace durero::conform
