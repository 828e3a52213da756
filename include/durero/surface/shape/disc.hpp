#pragma once
/// The surface of a disc: the equation of its plane, its ball and box.

#include "durero/surface/bounds.hpp"
#include "durero/surface/equation.hpp"

namespace durero::surface {

/// q·d (potencia_plano.def.1)
template <class T>
T potencia(const scene::Disc& disc, const Point<T>& w) {
  return dot(from(disc.centro, w), disc.vector);
}

/// The ball of the disc's centre and radius (puntos_disco.def.1).
inline Ball ball(const scene::Disc& disc) { return {disc.centro, disc.radio}; }
/// The box of a disc. Precondition: every number of the shape is 0 or of magnitude 2⁻¹⁰⁰ … 2¹⁰⁰.
inline Box box(const scene::Disc& disc) { return box_of_discs(disc.centro, disc.vector, 0, disc.radio, disc.radio); }

}  // namespace durero::surface
