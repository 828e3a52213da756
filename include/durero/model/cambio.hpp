#pragma once
/// The changes of spec/historia.tex: an element gets another value of one attribute, and stays the element that it is.
/// The schema of each attribute is a struct of its inputs with its effects on the attributes, and with the type that
/// its name says, if it says one: Cambiar_Radio_Esfera is a Cambiar_Radio of_type soy_esfera, as the text has it.

#include <optional>
#include <string>
#include <variant>

#include "durero/model/operaciones_clauses.hpp"

namespace durero::model {

inline constexpr clause Cambiar_Elemento_pre_1{"Cambiar_Elemento.pre.1", "e? ∈ elementos"};
inline constexpr clause Cambiar_Elemento_post_1{"Cambiar_Elemento.post.1", "elementos' = elementos"};
inline constexpr clause Cambiar_Elemento_post_2{"Cambiar_Elemento.post.2", "de_que_tipo' = de_que_tipo"};
inline constexpr clause Cambiar_Elemento_post_3{"Cambiar_Elemento.post.3", "r! = elemento_cambiado"};

// Cambiar_Centro

inline constexpr clause Cambiar_Centro_pre_1{"Cambiar_Centro.pre.1", "e? ∈ dom mi_centro"};
inline constexpr clause Cambiar_Centro_post_1{"Cambiar_Centro.post.1", "mi_centro' = mi_centro ⊕ { e? ↦ centro? }"};
inline constexpr clause Cambiar_Centro_post_2{"Cambiar_Centro.post.2", "mi_radio' = mi_radio"};
inline constexpr clause Cambiar_Centro_post_3{"Cambiar_Centro.post.3", "mi_vector' = mi_vector"};
inline constexpr clause Cambiar_Centro_post_4{"Cambiar_Centro.post.4", "mi_altura' = mi_altura"};
inline constexpr clause Cambiar_Centro_post_5{"Cambiar_Centro.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Cambiar_Centro_post_6{"Cambiar_Centro.post.6", "mi_vertices' = mi_vertices"};

/// Another centre (Cambiar_Centro).
struct Cambiar_Centro {
  Elemento e;
  Punto centro;
  std::optional<Tipo> of_type{};  ///< the type that the name says; none where it is Cambiar_Centro alone

  static constexpr auto component = &Escena::mi_centro;
  static constexpr std::string_view schema = "Cambiar_Centro";
  static constexpr const clause* has_attribute = &Cambiar_Centro_pre_1;
  static constexpr std::tuple<> requirements{};
  static constexpr std::tuple effects{Replaced<&Escena::mi_centro, &Cambiar_Centro::centro>{&Cambiar_Centro_post_1},
                                      Kept<&Escena::mi_radio>{&Cambiar_Centro_post_2},
                                      Kept<&Escena::mi_vector>{&Cambiar_Centro_post_3},
                                      Kept<&Escena::mi_altura>{&Cambiar_Centro_post_4},
                                      Kept<&Escena::mi_proporcion>{&Cambiar_Centro_post_5},
                                      Kept<&Escena::mi_vertices>{&Cambiar_Centro_post_6}};
};

inline constexpr clause Sin_Centro_pre_1{"Sin_Centro.pre.1", "e? ∈ elementos"};
inline constexpr clause Sin_Centro_pre_2{"Sin_Centro.pre.2", "e? ∉ dom mi_centro"};
inline constexpr clause Sin_Centro_post_1{"Sin_Centro.post.1", "r! = tipo_incorrecto"};

/// The type of the element has no centre (Sin_Centro).
struct Sin_Centro {
  Elemento e;

  static constexpr auto component = &Escena::mi_centro;
  static constexpr Respuesta answer = Respuesta::tipo_incorrecto;
  static constexpr const clause *exists = &Sin_Centro_pre_1, *lacks = &Sin_Centro_pre_2, *answers = &Sin_Centro_post_1;
};

// Cambiar_Radio

inline constexpr clause Cambiar_Radio_pre_1{"Cambiar_Radio.pre.1", "e? ∈ dom mi_radio"};
inline constexpr clause Cambiar_Radio_pre_2{"Cambiar_Radio.pre.2", "radio? ∈ Rmas"};
inline constexpr clause Cambiar_Radio_post_1{"Cambiar_Radio.post.1", "mi_radio' = mi_radio ⊕ { e? ↦ radio? }"};
inline constexpr clause Cambiar_Radio_post_2{"Cambiar_Radio.post.2", "mi_centro' = mi_centro"};
inline constexpr clause Cambiar_Radio_post_3{"Cambiar_Radio.post.3", "mi_vector' = mi_vector"};
inline constexpr clause Cambiar_Radio_post_4{"Cambiar_Radio.post.4", "mi_altura' = mi_altura"};
inline constexpr clause Cambiar_Radio_post_5{"Cambiar_Radio.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Cambiar_Radio_post_6{"Cambiar_Radio.post.6", "mi_vertices' = mi_vertices"};

/// Another radius (Cambiar_Radio).
struct Cambiar_Radio {
  Elemento e;
  double radio;
  std::optional<Tipo> of_type{};  ///< the type that the name says; none where it is Cambiar_Radio alone

  static constexpr auto component = &Escena::mi_radio;
  static constexpr std::string_view schema = "Cambiar_Radio";
  static constexpr const clause* has_attribute = &Cambiar_Radio_pre_1;
  static constexpr std::tuple requirements{Required<Rmas, Radio_No_Positivo>{&Cambiar_Radio_pre_2}};
  static constexpr std::tuple effects{Replaced<&Escena::mi_radio, &Cambiar_Radio::radio>{&Cambiar_Radio_post_1},
                                      Kept<&Escena::mi_centro>{&Cambiar_Radio_post_2},
                                      Kept<&Escena::mi_vector>{&Cambiar_Radio_post_3},
                                      Kept<&Escena::mi_altura>{&Cambiar_Radio_post_4},
                                      Kept<&Escena::mi_proporcion>{&Cambiar_Radio_post_5},
                                      Kept<&Escena::mi_vertices>{&Cambiar_Radio_post_6}};
};

inline constexpr clause Sin_Radio_pre_1{"Sin_Radio.pre.1", "e? ∈ elementos"};
inline constexpr clause Sin_Radio_pre_2{"Sin_Radio.pre.2", "e? ∉ dom mi_radio"};
inline constexpr clause Sin_Radio_post_1{"Sin_Radio.post.1", "r! = tipo_incorrecto"};

/// The type of the element has no radius (Sin_Radio).
struct Sin_Radio {
  Elemento e;

  static constexpr auto component = &Escena::mi_radio;
  static constexpr Respuesta answer = Respuesta::tipo_incorrecto;
  static constexpr const clause *exists = &Sin_Radio_pre_1, *lacks = &Sin_Radio_pre_2, *answers = &Sin_Radio_post_1;
};

// Cambiar_Vector

inline constexpr clause Cambiar_Vector_pre_1{"Cambiar_Vector.pre.1", "e? ∈ dom mi_vector"};
inline constexpr clause Cambiar_Vector_pre_2{"Cambiar_Vector.pre.2", "vector? ∈ Unitario"};
inline constexpr clause Cambiar_Vector_post_1{"Cambiar_Vector.post.1", "mi_vector' = mi_vector ⊕ { e? ↦ vector? }"};
inline constexpr clause Cambiar_Vector_post_2{"Cambiar_Vector.post.2", "mi_centro' = mi_centro"};
inline constexpr clause Cambiar_Vector_post_3{"Cambiar_Vector.post.3", "mi_radio' = mi_radio"};
inline constexpr clause Cambiar_Vector_post_4{"Cambiar_Vector.post.4", "mi_altura' = mi_altura"};
inline constexpr clause Cambiar_Vector_post_5{"Cambiar_Vector.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Cambiar_Vector_post_6{"Cambiar_Vector.post.6", "mi_vertices' = mi_vertices"};

/// Another axis (Cambiar_Vector).
struct Cambiar_Vector {
  Elemento e;
  Vector vector;
  std::optional<Tipo> of_type{};  ///< the type that the name says; none where it is Cambiar_Vector alone

  static constexpr auto component = &Escena::mi_vector;
  static constexpr std::string_view schema = "Cambiar_Vector";
  static constexpr const clause* has_attribute = &Cambiar_Vector_pre_1;
  static constexpr std::tuple requirements{Required<Unitario, Vector_No_Unitario>{&Cambiar_Vector_pre_2}};
  static constexpr std::tuple effects{Replaced<&Escena::mi_vector, &Cambiar_Vector::vector>{&Cambiar_Vector_post_1},
                                      Kept<&Escena::mi_centro>{&Cambiar_Vector_post_2},
                                      Kept<&Escena::mi_radio>{&Cambiar_Vector_post_3},
                                      Kept<&Escena::mi_altura>{&Cambiar_Vector_post_4},
                                      Kept<&Escena::mi_proporcion>{&Cambiar_Vector_post_5},
                                      Kept<&Escena::mi_vertices>{&Cambiar_Vector_post_6}};
};

inline constexpr clause Sin_Vector_pre_1{"Sin_Vector.pre.1", "e? ∈ elementos"};
inline constexpr clause Sin_Vector_pre_2{"Sin_Vector.pre.2", "e? ∉ dom mi_vector"};
inline constexpr clause Sin_Vector_post_1{"Sin_Vector.post.1", "r! = tipo_incorrecto"};

/// The type of the element has no axis (Sin_Vector).
struct Sin_Vector {
  Elemento e;

  static constexpr auto component = &Escena::mi_vector;
  static constexpr Respuesta answer = Respuesta::tipo_incorrecto;
  static constexpr const clause *exists = &Sin_Vector_pre_1, *lacks = &Sin_Vector_pre_2, *answers = &Sin_Vector_post_1;
};

// Cambiar_Altura

inline constexpr clause Cambiar_Altura_pre_1{"Cambiar_Altura.pre.1", "e? ∈ dom mi_altura"};
inline constexpr clause Cambiar_Altura_pre_2{"Cambiar_Altura.pre.2", "altura? ∈ Rmas"};
inline constexpr clause Cambiar_Altura_post_1{"Cambiar_Altura.post.1", "mi_altura' = mi_altura ⊕ { e? ↦ altura? }"};
inline constexpr clause Cambiar_Altura_post_2{"Cambiar_Altura.post.2", "mi_centro' = mi_centro"};
inline constexpr clause Cambiar_Altura_post_3{"Cambiar_Altura.post.3", "mi_radio' = mi_radio"};
inline constexpr clause Cambiar_Altura_post_4{"Cambiar_Altura.post.4", "mi_vector' = mi_vector"};
inline constexpr clause Cambiar_Altura_post_5{"Cambiar_Altura.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Cambiar_Altura_post_6{"Cambiar_Altura.post.6", "mi_vertices' = mi_vertices"};

/// Another height (Cambiar_Altura).
struct Cambiar_Altura {
  Elemento e;
  double altura;
  std::optional<Tipo> of_type{};  ///< the type that the name says; none where it is Cambiar_Altura alone

  static constexpr auto component = &Escena::mi_altura;
  static constexpr std::string_view schema = "Cambiar_Altura";
  static constexpr const clause* has_attribute = &Cambiar_Altura_pre_1;
  static constexpr std::tuple requirements{Required<Rmas, Altura_No_Positiva>{&Cambiar_Altura_pre_2}};
  static constexpr std::tuple effects{Replaced<&Escena::mi_altura, &Cambiar_Altura::altura>{&Cambiar_Altura_post_1},
                                      Kept<&Escena::mi_centro>{&Cambiar_Altura_post_2},
                                      Kept<&Escena::mi_radio>{&Cambiar_Altura_post_3},
                                      Kept<&Escena::mi_vector>{&Cambiar_Altura_post_4},
                                      Kept<&Escena::mi_proporcion>{&Cambiar_Altura_post_5},
                                      Kept<&Escena::mi_vertices>{&Cambiar_Altura_post_6}};
};

inline constexpr clause Sin_Altura_pre_1{"Sin_Altura.pre.1", "e? ∈ elementos"};
inline constexpr clause Sin_Altura_pre_2{"Sin_Altura.pre.2", "e? ∉ dom mi_altura"};
inline constexpr clause Sin_Altura_post_1{"Sin_Altura.post.1", "r! = tipo_incorrecto"};

/// The type of the element has no height (Sin_Altura).
struct Sin_Altura {
  Elemento e;

  static constexpr auto component = &Escena::mi_altura;
  static constexpr Respuesta answer = Respuesta::tipo_incorrecto;
  static constexpr const clause *exists = &Sin_Altura_pre_1, *lacks = &Sin_Altura_pre_2, *answers = &Sin_Altura_post_1;
};

// Cambiar_Proporcion

inline constexpr clause Cambiar_Proporcion_pre_1{"Cambiar_Proporcion.pre.1", "e? ∈ dom mi_proporcion"};
inline constexpr clause Cambiar_Proporcion_pre_2{"Cambiar_Proporcion.pre.2", "proporcion? ∈ Rmas"};
inline constexpr clause Cambiar_Proporcion_post_1{"Cambiar_Proporcion.post.1",
                                                  "mi_proporcion' = mi_proporcion ⊕ { e? ↦ proporcion? }"};
inline constexpr clause Cambiar_Proporcion_post_2{"Cambiar_Proporcion.post.2", "mi_centro' = mi_centro"};
inline constexpr clause Cambiar_Proporcion_post_3{"Cambiar_Proporcion.post.3", "mi_radio' = mi_radio"};
inline constexpr clause Cambiar_Proporcion_post_4{"Cambiar_Proporcion.post.4", "mi_vector' = mi_vector"};
inline constexpr clause Cambiar_Proporcion_post_5{"Cambiar_Proporcion.post.5", "mi_altura' = mi_altura"};
inline constexpr clause Cambiar_Proporcion_post_6{"Cambiar_Proporcion.post.6", "mi_vertices' = mi_vertices"};

/// Another proportion (Cambiar_Proporcion).
struct Cambiar_Proporcion {
  Elemento e;
  double proporcion;
  std::optional<Tipo> of_type{};  ///< the type that the name says; none where it is Cambiar_Proporcion alone

  static constexpr auto component = &Escena::mi_proporcion;
  static constexpr std::string_view schema = "Cambiar_Proporcion";
  static constexpr const clause* has_attribute = &Cambiar_Proporcion_pre_1;
  static constexpr std::tuple requirements{Required<Rmas, Proporcion_No_Positiva>{&Cambiar_Proporcion_pre_2}};
  static constexpr std::tuple effects{
      Replaced<&Escena::mi_proporcion, &Cambiar_Proporcion::proporcion>{&Cambiar_Proporcion_post_1},
      Kept<&Escena::mi_centro>{&Cambiar_Proporcion_post_2},
      Kept<&Escena::mi_radio>{&Cambiar_Proporcion_post_3},
      Kept<&Escena::mi_vector>{&Cambiar_Proporcion_post_4},
      Kept<&Escena::mi_altura>{&Cambiar_Proporcion_post_5},
      Kept<&Escena::mi_vertices>{&Cambiar_Proporcion_post_6}};
};

inline constexpr clause Sin_Proporcion_pre_1{"Sin_Proporcion.pre.1", "e? ∈ elementos"};
inline constexpr clause Sin_Proporcion_pre_2{"Sin_Proporcion.pre.2", "e? ∉ dom mi_proporcion"};
inline constexpr clause Sin_Proporcion_post_1{"Sin_Proporcion.post.1", "r! = tipo_incorrecto"};

/// The type of the element has no proportion (Sin_Proporcion).
struct Sin_Proporcion {
  Elemento e;

  static constexpr auto component = &Escena::mi_proporcion;
  static constexpr Respuesta answer = Respuesta::tipo_incorrecto;
  static constexpr const clause *exists = &Sin_Proporcion_pre_1, *lacks = &Sin_Proporcion_pre_2,
                                *answers = &Sin_Proporcion_post_1;
};

// Cambiar_Vertices

inline constexpr clause Cambiar_Vertices_pre_1{"Cambiar_Vertices.pre.1", "e? ∈ dom mi_vertices"};
inline constexpr clause Cambiar_Vertices_pre_2{"Cambiar_Vertices.pre.2", "vertices? ∈ Vertices"};
inline constexpr clause Cambiar_Vertices_post_1{"Cambiar_Vertices.post.1",
                                                "mi_vertices' = mi_vertices ⊕ { e? ↦ vertices? }"};
inline constexpr clause Cambiar_Vertices_post_2{"Cambiar_Vertices.post.2", "mi_centro' = mi_centro"};
inline constexpr clause Cambiar_Vertices_post_3{"Cambiar_Vertices.post.3", "mi_radio' = mi_radio"};
inline constexpr clause Cambiar_Vertices_post_4{"Cambiar_Vertices.post.4", "mi_vector' = mi_vector"};
inline constexpr clause Cambiar_Vertices_post_5{"Cambiar_Vertices.post.5", "mi_altura' = mi_altura"};
inline constexpr clause Cambiar_Vertices_post_6{"Cambiar_Vertices.post.6", "mi_proporcion' = mi_proporcion"};

/// Other vertices (Cambiar_Vertices).
struct Cambiar_Vertices {
  Elemento e;
  Terna vertices;
  std::optional<Tipo> of_type{};  ///< the type that the name says; none where it is Cambiar_Vertices alone

  static constexpr auto component = &Escena::mi_vertices;
  static constexpr std::string_view schema = "Cambiar_Vertices";
  static constexpr const clause* has_attribute = &Cambiar_Vertices_pre_1;
  static constexpr std::tuple requirements{Required<Vertices, Vertices_Alineados>{&Cambiar_Vertices_pre_2}};
  static constexpr std::tuple effects{
      Replaced<&Escena::mi_vertices, &Cambiar_Vertices::vertices>{&Cambiar_Vertices_post_1},
      Kept<&Escena::mi_centro>{&Cambiar_Vertices_post_2},
      Kept<&Escena::mi_radio>{&Cambiar_Vertices_post_3},
      Kept<&Escena::mi_vector>{&Cambiar_Vertices_post_4},
      Kept<&Escena::mi_altura>{&Cambiar_Vertices_post_5},
      Kept<&Escena::mi_proporcion>{&Cambiar_Vertices_post_6}};
};

inline constexpr clause Sin_Vertices_pre_1{"Sin_Vertices.pre.1", "e? ∈ elementos"};
inline constexpr clause Sin_Vertices_pre_2{"Sin_Vertices.pre.2", "e? ∉ dom mi_vertices"};
inline constexpr clause Sin_Vertices_post_1{"Sin_Vertices.post.1", "r! = tipo_incorrecto"};

/// The type of the element has no vertices (Sin_Vertices).
struct Sin_Vertices {
  Elemento e;

  static constexpr auto component = &Escena::mi_vertices;
  static constexpr Respuesta answer = Respuesta::tipo_incorrecto;
  static constexpr const clause *exists = &Sin_Vertices_pre_1, *lacks = &Sin_Vertices_pre_2,
                                *answers = &Sin_Vertices_post_1;
};

// All of them

/// The answer of every change that is done.
inline constexpr Respuesta change_answer = Respuesta::elemento_cambiado;

/// Any error of a change.
using ChangeError = std::variant<Error, Sin_Centro, Sin_Radio, Sin_Vector, Sin_Altura, Sin_Proporcion, Sin_Vertices>;

/// The clauses of an error that answers r, judged.
Judgements judgements(const Escena& escena, const ChangeError& error, Respuesta r);

/// Es_Esfera and its like: that e? is of the type.
const clause& of_type_clause(Tipo t);

/// e?
const Elemento& name_of(const AttributeChange& change);

/// @{ The name of its schema in the text, and of the total one: `Cambiar_Radio_Esfera`, `Cambiar_Radio_Esfera_Total`.
/// With a type they are Cambiar_Centro_Esfera.def.1, Cambiar_Radio_Esfera.def.1, Cambiar_Centro_Cilindro.def.1,
/// Cambiar_Radio_Cilindro.def.1, Cambiar_Vector_Cilindro.def.1, Cambiar_Altura_Cilindro.def.1,
/// Cambiar_Centro_Cono.def.1, Cambiar_Vector_Cono.def.1, Cambiar_Altura_Cono.def.1, Cambiar_Proporcion_Cono.def.1,
/// Cambiar_Centro_Tronco.def.1, Cambiar_Radio_Tronco.def.1, Cambiar_Vector_Tronco.def.1, Cambiar_Altura_Tronco.def.1,
/// Cambiar_Proporcion_Tronco.def.1, Cambiar_Centro_Plano.def.1, Cambiar_Vector_Plano.def.1, Cambiar_Centro_Disco.def.1,
/// Cambiar_Radio_Disco.def.1, Cambiar_Vector_Disco.def.1, and Cambiar_Vertices_Triangulo.def.1.
std::string schema_name(const AttributeChange& change);
std::string total_name(const AttributeChange& change);
/// @}

/// The preconditions over the before-state and the inputs, judged, in the order in which the total operation looks at
/// them: that the element exists, that it is of the type that is named or has the attribute, that the value is one.
Judgements pre(const Escena& before, const AttributeChange& change);

/// The postconditions over both states, the inputs and r!, judged: at `audit` price the whole predicates; at `normal`
/// price what changed of them (Delta).
Judgements post(const Escena& before, const AttributeChange& change, const Escena& after, Respuesta r,
                contract::cost price);

/// The partial operation. Throws contract_violation where a clause does not hold; the scene is then as it was.
Respuesta apply(Escena& escena, const AttributeChange& change);

/// The total operation: where a precondition does not hold it changes nothing and answers the error, the first in the
/// order of the text:
/// Cambiar_Centro_Total.def.1, Cambiar_Radio_Total.def.1, Cambiar_Vector_Total.def.1, Cambiar_Altura_Total.def.1,
/// Cambiar_Proporcion_Total.def.1, Cambiar_Vertices_Total.def.1, Cambiar_Centro_Esfera_Total.def.1,
/// Cambiar_Radio_Esfera_Total.def.1, Cambiar_Centro_Cilindro_Total.def.1, Cambiar_Radio_Cilindro_Total.def.1,
/// Cambiar_Vector_Cilindro_Total.def.1, Cambiar_Altura_Cilindro_Total.def.1, Cambiar_Centro_Cono_Total.def.1,
/// Cambiar_Vector_Cono_Total.def.1, Cambiar_Altura_Cono_Total.def.1, Cambiar_Proporcion_Cono_Total.def.1,
/// Cambiar_Centro_Tronco_Total.def.1, Cambiar_Radio_Tronco_Total.def.1, Cambiar_Vector_Tronco_Total.def.1,
/// Cambiar_Altura_Tronco_Total.def.1, Cambiar_Proporcion_Tronco_Total.def.1, Cambiar_Centro_Plano_Total.def.1,
/// Cambiar_Vector_Plano_Total.def.1, Cambiar_Centro_Disco_Total.def.1, Cambiar_Radio_Disco_Total.def.1,
/// Cambiar_Vector_Disco_Total.def.1, and Cambiar_Vertices_Triangulo_Total.def.1.
/// Any of them is a Cambio_Total.def.1.
Answer apply_total(Escena& escena, const AttributeChange& change);

/// One operation on the elements of a scene.
using ElementOperation = std::variant<Operation, AttributeChange>;

/// The total operation, of either kind.
Answer apply_either(Escena& escena, const ElementOperation& operation);

}  // namespace durero::model
