#pragma once
/// spec/haces.tex: rays made wide. Each function is the definition of the same name, carried out in exact arithmetic;
/// each set of the text is the predicate that its members satisfy.

#include "durero/model/iluminacion.hpp"
#include "durero/model/operation.hpp"
#include "durero/model/tipos.hpp"

namespace durero::model {

/// (eje, rayo, c) ∈ cono_de_rayos: the ray starts where the axis does, and makes no greater angle with it than one
/// below a right angle whose cosine has the square c (cono_de_rayos.def.1). Precondition: 0 ≤ c ≤ 1.
bool cono_de_rayos(const Rayo& eje, const Rayo& rayo, const Rational& c);

/// (θEscena, eje, rayo, c, e) ∈ cubierto: it is a ray of the cone, and meets the element (cubierto.def.1).
/// Precondition: that of cono_de_rayos.
bool cubierto(const Escena& escena, const Rayo& eje, const Rayo& rayo, const Rational& c, const Elemento& e);

// The bases of beams that have a name here are the points of an element. Precondition: it is of the scene.

/// (o, puntos_de_elemento(θEscena, e), rayo) ∈ haz: the ray starts at o and leads through one of them (haz.def.1).
bool haz(const Punto& o, const Escena& escena, const Elemento& e, const Rayo& rayo);

/// (o, puntos_de_elemento(θEscena, e), a, n, w) ∈ seccion: w is on the plane through a across n, and on a ray of the
/// beam (seccion.def.1). Throws std::domain_error where a component of w − o is no binary64: the ray then has no name
/// here.
bool seccion(const Punto& o, const Escena& escena, const Elemento& e, const Punto& a, const Vector& n, const Punto& w);

/// (a, n, p, q) ∈ imagen: q is the mirror image of p in the plane through a across n (imagen.def.1).
bool imagen(const Punto& a, const Vector& n, const ExactPoint& p, const ExactPoint& q);

/// The only q with (a, n, p, q) ∈ imagen. Throws std::domain_error where n = 0: there is none.
ExactPoint image(const Punto& a, const Vector& n, const ExactPoint& p);

/// A ray beside an axis.
struct Desvio {
  Rational x, y;  ///< how far it is off across the axis, in two directions at right angles
  Rational u, v;  ///< how much it leans that way, as slopes
  bool operator==(const Desvio&) const = default;
};

/// The matrix of a pencil, by its rows.
struct Matriz {
  Desvio x, y, u, v;  ///< the row that gives the component of that name
  bool operator==(const Matriz&) const = default;
};

/// A pencil: an axis, and where the rays beside it arrive.
struct Pincel {
  Rayo eje;  ///< the axis
  Matriz m;  ///< of the rays beside it
};

/// The only e with (m, d, e) ∈ aplicado (aplicado.def.1).
Desvio aplicado(const Matriz& m, const Desvio& d);

/// The only e with (t, d, e) ∈ traslado (traslado.def.1).
Desvio traslado(const Rational& t, const Desvio& d);

/// The only e with (r, razon, d, e) ∈ refraccion_paraxial (refraccion_paraxial.def.1). Throws std::domain_error where
/// r = 0: there is none, or there are many. Precondition: razon > 0.
Desvio refraccion_paraxial(const Rational& r, const Rational& razon, const Desvio& d);

}  // namespace durero::model
