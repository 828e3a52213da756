#pragma once
/// spec/auditoria.tex: what may be wrong with points and faces, though each face be a triangle. The functions follow
/// the text, slowly; mesh::audited says the same of large meshes.

#include <array>
#include <set>
#include <utility>

#include "durero/model/malla.hpp"
#include "durero/number/rational.hpp"

namespace durero::model {

/// An edge: the numbers of its two points.
using Arista = std::pair<Ordinal, Ordinal>;

/// The edges that a face walks, each from one number to the next (aristas.def.1).
std::set<Arista> aristas(const Cara& c);

/// The faces that have the edge, whichever way they walk it (de_arista.def.1).
std::set<Ordinal> de_arista(const Red& red, Ordinal i, Ordinal j);

/// @{ The edges of one face (abiertas.def.1) and of more than two (multiples.def.1), the lesser number first.
std::set<Arista> abiertas(const Red& red);
std::set<Arista> multiples(const Red& red);
/// @}

/// The edges that more than one face walks the same way, in that direction (discordes.def.1).
std::set<Arista> discordes(const Red& red);

/// The faces that have the points of one before them (repetidas.def.1).
std::set<Ordinal> repetidas(const Red& red);

/// The faces whose points lie on one line (degeneradas.def.1). Precondition: is_complete(red).
std::set<Ordinal> degeneradas(const Red& red);

/// The points of faces that lie between the ends of an edge: the number of the point, and those of the edge, the lesser
/// first (uniones_en_t.def.1). Precondition: is_complete(red).
std::set<std::array<Ordinal, 3>> uniones_en_t(const Red& red);

/// The numbers of the corners of a face (esquinas.def.1).
std::set<Ordinal> esquinas(const Cara& c);

/// w ∈ envolvente(red, s): whether a point is a mean of some points, at most three, by weights that are not negative
/// (envolvente.def.1). Precondition: s ⊆ dom red.puntos.
bool is_in_envolvente(const Red& red, const std::set<Ordinal>& s, const Punto& w);

/// The pairs of faces, the lesser number first, that have more points in common than the corners that they share, or
/// the edge between these (cruzadas.def.1). Precondition: is_complete(red).
std::set<std::pair<Ordinal, Ordinal>> cruzadas(const Red& red);

/// The faces that have a point (de_punto.def.1).
std::set<Ordinal> de_punto(const Red& red, Ordinal v);

/// The points whose faces fall into two parts that share that point alone (singulares.def.1).
std::set<Ordinal> singulares(const Red& red);

/// s ∈ cerradas(red): some faces, and no face outside has a point of one inside (cerradas.def.1).
bool is_closed(const Red& red, const std::set<Ordinal>& s);

/// The least closed sets of faces (piezas.def.1).
std::set<std::set<Ordinal>> piezas(const Red& red);

/// Six times the volume between the origin and three points (determinante.def.1).
number::Rational determinante(const Terna& v);

/// The volume that the faces enclose, where they are closed (volumen.def.1): the m of (red, m) ∈ volumen. Precondition:
/// is_complete(red).
number::Rational volumen(const Red& red);

/// red ∈ pares: each edge has an even number of faces, and each face is a triangle (pares.def.1).
bool is_even(const Red& red);

/// w ∈ piel(red): whether a point is one of some face (piel.def.1). Precondition: is_complete(red).
bool is_in_piel(const Red& red, const Punto& w);

/// (red, w) ∈ encerrados: whether a ray from a point meets no edge, and an odd number of faces (encerrados.def.1).
bool is_enclosed(const Red& red, const Punto& w);

}  // namespace durero::model
