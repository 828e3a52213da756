#pragma once
/// What the text says of a disc: its operations, the error of a removal that means another type, and its points.

#include "durero/model/operaciones_errors.hpp"
#include "durero/model/schema.hpp"

namespace durero::model {

// Agregar_Disco

inline constexpr clause Agregar_Disco_pre_1{"Agregar_Disco.pre.1", "t? = soy_disco"};
inline constexpr clause Agregar_Disco_pre_2{"Agregar_Disco.pre.2", "radio? ∈ Rmas"};
inline constexpr clause Agregar_Disco_pre_3{"Agregar_Disco.pre.3", "vector? ∈ Unitario"};
inline constexpr clause Agregar_Disco_post_1{"Agregar_Disco.post.1", "mi_centro' = mi_centro ∪ { e? ↦ centro? }"};
inline constexpr clause Agregar_Disco_post_2{"Agregar_Disco.post.2", "mi_radio' = mi_radio ∪ { e? ↦ radio? }"};
inline constexpr clause Agregar_Disco_post_3{"Agregar_Disco.post.3", "mi_vector' = mi_vector ∪ { e? ↦ vector? }"};
inline constexpr clause Agregar_Disco_post_4{"Agregar_Disco.post.4", "mi_altura' = mi_altura"};
inline constexpr clause Agregar_Disco_post_5{"Agregar_Disco.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Agregar_Disco_post_6{"Agregar_Disco.post.6", "mi_vertices' = mi_vertices"};
inline constexpr clause Agregar_Disco_post_7{"Agregar_Disco.post.7", "r! = disco_agregado"};

struct Agregar_Disco {
  Elemento e;
  Punto centro;
  double radio;
  Vector vector;
  Tipo t = tipo;

  static constexpr Tipo tipo = Tipo::soy_disco;
  static constexpr Respuesta answer = Respuesta::disco_agregado;
  static constexpr std::string_view schema = "Agregar_Disco";
  static constexpr std::string_view total = "Agregar_Disco_Total";  ///< Agregar_Disco_Total.def.1

  static constexpr const clause* is_of_type = &Agregar_Disco_pre_1;
  static constexpr std::tuple requirements{Required<Rmas, Radio_No_Positivo>{&Agregar_Disco_pre_2},
                                           Required<Unitario, Vector_No_Unitario>{&Agregar_Disco_pre_3}};
  static constexpr std::tuple effects{Joined<&Escena::mi_centro, &Agregar_Disco::centro>{&Agregar_Disco_post_1},
                                      Joined<&Escena::mi_radio, &Agregar_Disco::radio>{&Agregar_Disco_post_2},
                                      Joined<&Escena::mi_vector, &Agregar_Disco::vector>{&Agregar_Disco_post_3},
                                      Kept<&Escena::mi_altura>{&Agregar_Disco_post_4},
                                      Kept<&Escena::mi_proporcion>{&Agregar_Disco_post_5},
                                      Kept<&Escena::mi_vertices>{&Agregar_Disco_post_6}};
  static constexpr const clause* answers = &Agregar_Disco_post_7;
};

// Es_Disco

inline constexpr clause Es_Disco_pre_1{"Es_Disco.pre.1", "e? ↦ soy_disco ∈ de_que_tipo"};

// No_Es_Disco

inline constexpr clause No_Es_Disco_pre_1{"No_Es_Disco.pre.1", "e? ∈ elementos"};
inline constexpr clause No_Es_Disco_pre_2{"No_Es_Disco.pre.2", "de_que_tipo(e?) ≠ soy_disco"};
inline constexpr clause No_Es_Disco_post_1{"No_Es_Disco.post.1", "r! = tipo_incorrecto"};

struct No_Es_Disco {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_disco;
  static constexpr Respuesta answer = Respuesta::tipo_incorrecto;
  static constexpr const clause *exists = &No_Es_Disco_pre_1, *is_of_another_type = &No_Es_Disco_pre_2,
                                *answers = &No_Es_Disco_post_1;
};

// Eliminar_Disco

inline constexpr clause Eliminar_Disco_pre_1{"Eliminar_Disco.pre.1", "de_que_tipo(e?) = soy_disco"};
inline constexpr clause Eliminar_Disco_post_1{"Eliminar_Disco.post.1", "mi_centro' = { e? } ⩤ mi_centro"};
inline constexpr clause Eliminar_Disco_post_2{"Eliminar_Disco.post.2", "mi_radio' = { e? } ⩤ mi_radio"};
inline constexpr clause Eliminar_Disco_post_3{"Eliminar_Disco.post.3", "mi_vector' = { e? } ⩤ mi_vector"};
inline constexpr clause Eliminar_Disco_post_4{"Eliminar_Disco.post.4", "mi_altura' = mi_altura"};
inline constexpr clause Eliminar_Disco_post_5{"Eliminar_Disco.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Eliminar_Disco_post_6{"Eliminar_Disco.post.6", "mi_vertices' = mi_vertices"};
inline constexpr clause Eliminar_Disco_post_7{"Eliminar_Disco.post.7", "r! = disco_eliminado"};

struct Eliminar_Disco {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_disco;
  static constexpr Respuesta answer = Respuesta::disco_eliminado;
  static constexpr std::string_view schema = "Eliminar_Disco";
  static constexpr std::string_view total = "Eliminar_Disco_Total";  ///< Eliminar_Disco_Total.def.1
  using Denial = No_Es_Disco;

  static constexpr const clause* is_of_type = &Eliminar_Disco_pre_1;
  static constexpr std::tuple effects{
      Dropped<&Escena::mi_centro>{&Eliminar_Disco_post_1},  Dropped<&Escena::mi_radio>{&Eliminar_Disco_post_2},
      Dropped<&Escena::mi_vector>{&Eliminar_Disco_post_3},  Kept<&Escena::mi_altura>{&Eliminar_Disco_post_4},
      Kept<&Escena::mi_proporcion>{&Eliminar_Disco_post_5}, Kept<&Escena::mi_vertices>{&Eliminar_Disco_post_6}};
  static constexpr const clause* answers = &Eliminar_Disco_post_7;
};

// Points

/// The points of a disc, with its rim (puntos_disco.def.1). The power of a point is that of its plane (potencia.def.1).
Puntos puntos_disco(const Punto& centro, const Rmas& radio, const Vector& dir);

/// What the definitions by cases of the text say of a disc.
struct Disco {
  using Addition = Agregar_Disco;
  using Removal = Eliminar_Disco;
  static constexpr Tipo tipo = Tipo::soy_disco;
  static constexpr const clause* is_of_type = &Es_Disco_pre_1;  ///< where a change names the type

  /// The case of potencia.def.1. It outlives the scene.
  static Potencia potencia(const Escena& escena, const Elemento& e);
  /// The case of puntos_de_elemento.def.1.
  static Puntos puntos(const Escena& escena, const Elemento& e);
};

}  // namespace durero::model
