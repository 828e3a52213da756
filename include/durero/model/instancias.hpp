#pragma once
/// spec/instancias.tex: affine maps, the copies that they make of sets of points, and the instances of elements. Each
/// function is the definition of the same name, carried out in exact arithmetic.

#include "durero/model/interseccion.hpp"

namespace durero::model {

inline constexpr contract::clause Mapa_inv_1{"Mapa.inv.1", "mixto(x, y, z) ≠ 0"};

/// a · (b × c) (mixto.def.1).
Rational mixto(const ExactVector& a, const ExactVector& b, const ExactVector& c);

/// An affine map with rational entries. A plain value: inv() evaluates its invariant.
struct Mapa {
  ExactVector centro;   ///< where the origin goes
  ExactVector x, y, z;  ///< what becomes of the axes
};

/// Whether the entries are the same numbers.
bool operator==(const Mapa& m, const Mapa& n);

/// Mapa.inv.1.
Judgements inv(const Mapa& m);

// Precondition of all that follows: inv() of each map holds.

/// The only w with (m, u, w) ∈ puesto (puesto.def.1).
ExactPoint puesto(const Mapa& m, const ExactPoint& u);

/// The only w with (m, u, w) ∈ dirigido (dirigido.def.1).
ExactVector dirigido(const Mapa& m, const ExactVector& u);

/// The only u with (m, w, u) ∈ visto (visto.def.1).
ExactPoint visto(const Mapa& m, const ExactPoint& w);

/// The copy of a set; it draws where the set does (copia.def.1).
Puntos copia(const Mapa& m, const Puntos& ps);

/// A ray whose numbers need not be binary64.
struct ExactRay {
  ExactPoint p;   ///< the origin, which is no point of the ray
  ExactVector v;  ///< the direction
};

/// The only otro with (m, rayo, otro) ∈ movido (movido.def.1).
ExactRay movido(const Mapa& m, const Rayo& rayo);

/// The only k with (m, n, k) ∈ compuesto: first n, then m (compuesto.def.1).
Mapa compuesto(const Mapa& m, const Mapa& n);

/// m ∈ identidad (identidad.def.1).
bool identidad(const Mapa& m);
/// The only member of identidad.
Mapa identity();

/// (m, r, h) ∈ estirado (estirado.def.1).
bool estirado(const Mapa& m, const Rmas& r, const Rmas& h);

// Of the functions of an element, each throws std::out_of_range where e ∉ elementos.

/// The points of an instance of e (puntos_de_instancia.def.1).
Puntos puntos_de_instancia(const Escena& escena, const Mapa& m, const Elemento& e);

/// The points of an instance that a ray sees which starts at p, known to lie on it (instancia_desde.def.1).
Puntos instancia_desde(const Escena& escena, const Mapa& m, const Elemento& e, const ExactPoint& p);

}  // namespace durero::model
