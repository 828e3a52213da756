#pragma once
/// spec/distancias.tex: how far a point is from a set of points. Each function is the definition of the same name,
/// carried out in exact arithmetic; a set is given by some of its points, and is those.

#include <optional>
#include <set>
#include <span>
#include <vector>

#include "durero/model/interseccion.hpp"

namespace durero::model {

/// The points of a set that are nearest to p, in the order given; a point that is given twice is one (cercanos.def.1).
std::vector<ExactPoint> cercanos(std::span<const ExactPoint> ps, const Punto& p);

/// The r with (ps, p, r) ∈ a_distancia; nothing of the empty set (a_distancia.def.1).
std::optional<Distancia> a_distancia(std::span<const ExactPoint> ps, const Punto& p);

/// (θEscena, e, p, r) ∈ con_signo, where the nearest points of e are among ps (con_signo.def.1). Precondition: ps are
/// points of e. Throws std::out_of_range where e ∉ elementos.
bool con_signo(const Escena& escena, const Elemento& e, const Punto& p, const Surd& r, std::span<const ExactPoint> ps);

/// (a, b) ∈ antes: by x, then by y, then by z (antes.def.1).
bool antes(const ExactPoint& a, const ExactPoint& b);

/// (θEscena, p, d, w, en) ∈ mas_cercano, where the points that speak against it are among `otros` (mas_cercano.def.1).
/// Precondition: otros are points of the scene, and one of each element of en is among them, or is w, at the distance.
bool mas_cercano(const Escena& escena, const Punto& p, const Distancia& d, const ExactPoint& w,
                 const std::set<Elemento>& en, std::span<const ExactPoint> otros);

}  // namespace durero::model
