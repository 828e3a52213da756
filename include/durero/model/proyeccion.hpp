#pragma once
/// spec/proyeccion.tex: shadows, projections, the test of a depth map and what is drawn over what. Each function is the
/// definition of the same name, carried out in exact arithmetic, where its sets of points are those of triangles.

#include <optional>
#include <vector>

#include "durero/model/interseccion.hpp"
#include "durero/model/luz.hpp"

namespace durero::model {

// Precondition of all that follows: the points that a function is given lie in one field.

/// (x, y, q) ∈ entre: q stands between the two others (entre.def.1).
bool entre(const ExactPoint& x, const ExactPoint& y, const ExactPoint& q);

/// The shadow of a triangle, of the light y (sombra.def.1).
Puntos sombra(const ExactPoint& y, const Terna& triangle);

/// The part of a triangle that lies in the shadow of none of the others (iluminada.def.1).
Puntos iluminada(const ExactPoint& y, const Terna& triangle, const std::vector<Terna>& otros);

/// The only x with (y, p, centro, dir, x) ∈ proyectado (proyectado.def.1); nothing where there is none. A ray within
/// the plane throws std::domain_error: all its points are projections.
std::optional<ExactPoint> proyectado(const ExactPoint& y, const ExactPoint& p, const Punto& centro, const Vector& dir);

/// The d with (rayo, the points of the scene, d) ∈ profundidad (profundidad.def.1); nothing where there is none.
std::optional<Distancia> profundidad(const Escena& escena, const Rayo& rayo);

/// (d, q, y) ∈ oscura (oscura.def.1).
bool oscura(const Distancia& d, const ExactPoint& q, const ExactPoint& y);

/// The colour that a transparent polygon makes of the one behind it (mezcla.def.1).
Surd mezcla(const Material& m, const Surd& propio, const Surd& I);

}  // namespace durero::model
