#pragma once
/// spec/interseccion.tex: the intersection of sets of points, its reduction, and the closest intersection. Each
/// function is the definition of the same name, carried out in exact arithmetic.

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "durero/model/judgement.hpp"
#include "durero/model/on_ray.hpp"
#include "durero/model/puntos.hpp"
#include "durero/model/resultado.hpp"

namespace durero::model {

inline constexpr contract::clause Pregunta_pre_1{"Pregunta.pre.1", "en? ⊆ elementos"};
inline constexpr contract::clause Hay_Interseccion_pre_1{"Hay_Interseccion.pre.1",
                                                         "(alcances(θEscena, rayo?, en?), rayo?.p) ∈ dom reduccion"};
inline constexpr contract::clause Hay_Interseccion_post_1{"Hay_Interseccion.post.1",
                                                          "punto! = reduccion(alcances(θEscena, rayo?, en?), rayo?.p)"};
inline constexpr contract::clause Hay_Interseccion_post_2{
    "Hay_Interseccion.post.2",
    "punto!.x = rayo?.p.x + t! * rayo?.v.x ∧ punto!.y = rayo?.p.y + t! * rayo?.v.y ∧ punto!.z = rayo?.p.z + t! * "
    "rayo?.v.z"};
inline constexpr contract::clause Hay_Interseccion_post_3{
    "Hay_Interseccion.post.3", "elementos! = { e : elementos | punto! ∈ alcance(θEscena, rayo?, en?, e) }"};
inline constexpr contract::clause Hay_Interseccion_post_4{"Hay_Interseccion.post.4", "resultado! = hit"};
inline constexpr contract::clause No_Hay_Interseccion_pre_1{"No_Hay_Interseccion.pre.1",
                                                            "alcances(θEscena, rayo?, en?) = ∅"};
inline constexpr contract::clause No_Hay_Interseccion_post_1{"No_Hay_Interseccion.post.1", "elementos! = ∅"};
inline constexpr contract::clause No_Hay_Interseccion_post_2{"No_Hay_Interseccion.post.2", "resultado! = miss"};
inline constexpr contract::clause No_Hay_Minimo_pre_1{"No_Hay_Minimo.pre.1", "alcances(θEscena, rayo?, en?) ≠ ∅"};
inline constexpr contract::clause No_Hay_Minimo_pre_2{"No_Hay_Minimo.pre.2",
                                                      "(alcances(θEscena, rayo?, en?), rayo?.p) ∉ dom reduccion"};
inline constexpr contract::clause No_Hay_Minimo_post_1{
    "No_Hay_Minimo.post.1",
    "elementos! = { e : elementos | alcance(θEscena, rayo?, en?, e) ≠ ∅ ∧ (alcance(θEscena, rayo?, en?, e), rayo?.p) ∉ "
    "dom reduccion }"};
inline constexpr contract::clause No_Hay_Minimo_post_2{"No_Hay_Minimo.post.2", "resultado! = no_minimum"};

/// ps ∩ qs, for every two sets (interseccion.def.1). It does not say how to draw from it.
Puntos interseccion(const Puntos& ps, const Puntos& qs);

/// A distance, held by its square: its own field is not that of the coordinates. Distances are not negative, so they
/// are ordered as their squares are.
struct Distancia {
  Surd square;  ///< not negative
  /// @{ As their squares are.
  auto operator<=>(const Distancia& other) const { return square <=> other.square; }
  bool operator==(const Distancia& other) const { return square == other.square; }
  /// @}
};

/// The root of the sum of the squares of the differences (distancia.def.1). Precondition: a and b lie in one field.
Distancia distancia(const ExactPoint& a, const ExactPoint& b);

/// The only point of a finite set that no other is nearer to the eye than (reduccion.def.2); nothing where there is no
/// such point or there are several (reduccion.def.1: the set is then outside its domain). A point that is given
/// twice is one point.
std::optional<ExactPoint> reduccion(std::span<const ExactPoint> ps, const Punto& ojo);

/// The elements that a point lies on (de_que_elemento.def.1).
std::set<Elemento> de_que_elemento(const Escena& escena, const ExactPoint& p);

// Of the functions of an element, each throws std::out_of_range where e ∉ elementos.

/// The power of w with respect to the surface of e (potencia.def.1).
Surd potencia(const Escena& escena, const Elemento& e, const ExactPoint& w);

/// The points within the bounds of an element: the advances of its stretch of the axis, the ball of a disc, the prism
/// of a triangle (tramo.def.1).
Puntos tramo(const Escena& escena, const Elemento& e);

/// What a ray that starts at p, known to lie on e, sees of e: the points whose power is p's (puntos_desde.def.1).
Puntos puntos_desde(const Escena& escena, const Elemento& e, const ExactPoint& p);

/// A set of points of a ray: by membership, as the text has it, and by its parameters.
struct Alcance {
  Puntos puntos;          ///< by membership
  Parameters parameters;  ///< by the parameters of the ray
};

/// The points of e that the ray meets, when it starts on the elements `en` (alcance.def.1).
Alcance alcance(const Escena& escena, const Rayo& rayo, const std::set<Elemento>& en, const Elemento& e);

/// The same for every element, whose union is the text's alcances (alcances.def.1).
std::map<Elemento, Alcance> alcances(const Escena& escena, const Rayo& rayo, const std::set<Elemento>& en);

/// The parameter of the point of their union that is nearest to the origin of the ray (reduccion.def.1,
/// reduccion.def.2); nothing where there is none: they are empty, or one comes as near to the origin as one likes.
std::optional<Surd> reduccion(const std::map<Elemento, Alcance>& alcances);

/// rayo?, en? (Pregunta)
struct Pregunta {
  Rayo rayo;              ///< rayo?
  std::set<Elemento> en;  ///< en?, the elements that its origin lies on
};

// The outcomes of the closest intersection, each with its outputs.

struct Hay_Interseccion {
  Resultado resultado;           ///< resultado!, which is hit
  std::set<Elemento> elementos;  ///< elementos!, those that the point lies on
  Surd t;                        ///< t!, the parameter of the point
  ExactPoint punto;              ///< punto!, the nearest to the origin of the ray
};

struct No_Hay_Interseccion {
  Resultado resultado;           ///< resultado!, which is miss
  std::set<Elemento> elementos;  ///< elementos!, none
};

struct No_Hay_Minimo {
  Resultado resultado;           ///< resultado!, which is no_minimum
  std::set<Elemento> elementos;  ///< elementos!, those without a nearest point
};

/// Pregunta.pre.1 and, where Schema is an outcome, its own preconditions.
Judgements pre(const Escena& escena, const Pregunta& in);
/// The same with the preconditions of that outcome.
template <class Schema>
Judgements pre(const Escena& escena, const Pregunta& in);

/// @{ The postconditions of an outcome, over the inputs and its outputs.
Judgements post(const Escena& escena, const Pregunta& in, const Hay_Interseccion& out);
Judgements post(const Escena& escena, const Pregunta& in, const No_Hay_Interseccion& out);
Judgements post(const Escena& escena, const Pregunta& in, const No_Hay_Minimo& out);
/// @}

/// The closest intersection (Primera_Interseccion.def.1): the outcome whose preconditions hold, which is always exactly
/// one. Its postconditions
/// are checked. Throws contract_violation Pregunta.pre.1 where en? ⊈ elementos.
std::variant<Hay_Interseccion, No_Hay_Interseccion, No_Hay_Minimo> Primera_Interseccion(const Escena& escena,
                                                                                        const Pregunta& in);

/// Whether anything stands in the way of the ray (occluded.def.1).
bool occluded(const Escena& escena, const Rayo& rayo, const std::set<Elemento>& en);

/// Whether anything stands in its way before its parameter one (occluded_segment.def.1).
bool occluded_segment(const Escena& escena, const Rayo& rayo, const std::set<Elemento>& en);

}  // namespace durero::model
