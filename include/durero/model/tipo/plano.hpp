#pragma once
/// What the text says of a plane: its operations, the error of a removal that means another type, and its points.

#include "durero/model/operaciones_errors.hpp"
#include "durero/model/schema.hpp"

namespace durero::model {

// Agregar_Plano

inline constexpr clause Agregar_Plano_pre_1{"Agregar_Plano.pre.1", "t? = soy_plano"};
inline constexpr clause Agregar_Plano_pre_2{"Agregar_Plano.pre.2", "vector? ∈ Unitario"};
inline constexpr clause Agregar_Plano_post_1{"Agregar_Plano.post.1", "mi_centro' = mi_centro ∪ { e? ↦ centro? }"};
inline constexpr clause Agregar_Plano_post_2{"Agregar_Plano.post.2", "mi_radio' = mi_radio"};
inline constexpr clause Agregar_Plano_post_3{"Agregar_Plano.post.3", "mi_vector' = mi_vector ∪ { e? ↦ vector? }"};
inline constexpr clause Agregar_Plano_post_4{"Agregar_Plano.post.4", "mi_altura' = mi_altura"};
inline constexpr clause Agregar_Plano_post_5{"Agregar_Plano.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Agregar_Plano_post_6{"Agregar_Plano.post.6", "mi_vertices' = mi_vertices"};
inline constexpr clause Agregar_Plano_post_7{"Agregar_Plano.post.7", "r! = plano_agregado"};

struct Agregar_Plano {
  Elemento e;
  Punto centro;
  Vector vector;
  Tipo t = tipo;

  static constexpr Tipo tipo = Tipo::soy_plano;
  static constexpr Respuesta answer = Respuesta::plano_agregado;
  static constexpr std::string_view schema = "Agregar_Plano";
  static constexpr std::string_view total = "Agregar_Plano_Total";  ///< Agregar_Plano_Total.def.1

  static constexpr const clause* is_of_type = &Agregar_Plano_pre_1;
  static constexpr std::tuple requirements{Required<Unitario, Vector_No_Unitario>{&Agregar_Plano_pre_2}};
  static constexpr std::tuple effects{Joined<&Escena::mi_centro, &Agregar_Plano::centro>{&Agregar_Plano_post_1},
                                      Kept<&Escena::mi_radio>{&Agregar_Plano_post_2},
                                      Joined<&Escena::mi_vector, &Agregar_Plano::vector>{&Agregar_Plano_post_3},
                                      Kept<&Escena::mi_altura>{&Agregar_Plano_post_4},
                                      Kept<&Escena::mi_proporcion>{&Agregar_Plano_post_5},
                                      Kept<&Escena::mi_vertices>{&Agregar_Plano_post_6}};
  static constexpr const clause* answers = &Agregar_Plano_post_7;
};

// Es_Plano

inline constexpr clause Es_Plano_pre_1{"Es_Plano.pre.1", "e? ↦ soy_plano ∈ de_que_tipo"};

// No_Es_Plano

inline constexpr clause No_Es_Plano_pre_1{"No_Es_Plano.pre.1", "e? ∈ elementos"};
inline constexpr clause No_Es_Plano_pre_2{"No_Es_Plano.pre.2", "de_que_tipo(e?) ≠ soy_plano"};
inline constexpr clause No_Es_Plano_post_1{"No_Es_Plano.post.1", "r! = tipo_incorrecto"};

struct No_Es_Plano {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_plano;
  static constexpr Respuesta answer = Respuesta::tipo_incorrecto;
  static constexpr const clause *exists = &No_Es_Plano_pre_1, *is_of_another_type = &No_Es_Plano_pre_2,
                                *answers = &No_Es_Plano_post_1;
};

// Eliminar_Plano

inline constexpr clause Eliminar_Plano_pre_1{"Eliminar_Plano.pre.1", "de_que_tipo(e?) = soy_plano"};
inline constexpr clause Eliminar_Plano_post_1{"Eliminar_Plano.post.1", "mi_centro' = { e? } ⩤ mi_centro"};
inline constexpr clause Eliminar_Plano_post_2{"Eliminar_Plano.post.2", "mi_radio' = mi_radio"};
inline constexpr clause Eliminar_Plano_post_3{"Eliminar_Plano.post.3", "mi_vector' = { e? } ⩤ mi_vector"};
inline constexpr clause Eliminar_Plano_post_4{"Eliminar_Plano.post.4", "mi_altura' = mi_altura"};
inline constexpr clause Eliminar_Plano_post_5{"Eliminar_Plano.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Eliminar_Plano_post_6{"Eliminar_Plano.post.6", "mi_vertices' = mi_vertices"};
inline constexpr clause Eliminar_Plano_post_7{"Eliminar_Plano.post.7", "r! = plano_eliminado"};

struct Eliminar_Plano {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_plano;
  static constexpr Respuesta answer = Respuesta::plano_eliminado;
  static constexpr std::string_view schema = "Eliminar_Plano";
  static constexpr std::string_view total = "Eliminar_Plano_Total";  ///< Eliminar_Plano_Total.def.1
  using Denial = No_Es_Plano;

  static constexpr const clause* is_of_type = &Eliminar_Plano_pre_1;
  static constexpr std::tuple effects{
      Dropped<&Escena::mi_centro>{&Eliminar_Plano_post_1},  Kept<&Escena::mi_radio>{&Eliminar_Plano_post_2},
      Dropped<&Escena::mi_vector>{&Eliminar_Plano_post_3},  Kept<&Escena::mi_altura>{&Eliminar_Plano_post_4},
      Kept<&Escena::mi_proporcion>{&Eliminar_Plano_post_5}, Kept<&Escena::mi_vertices>{&Eliminar_Plano_post_6}};
  static constexpr const clause* answers = &Eliminar_Plano_post_7;
};

// Points

/// The power of w with respect to a plane: its advance along the normal (potencia_plano.def.1).
Surd potencia_plano(const ExactPoint& w, const Punto& centro, const Vector& dir);

/// The points of a plane, which has no bound (puntos_plano.def.1).
Puntos puntos_plano(const Punto& centro, const Vector& dir);

/// What the definitions by cases of the text say of a plane.
struct Plano {
  using Addition = Agregar_Plano;
  using Removal = Eliminar_Plano;
  static constexpr Tipo tipo = Tipo::soy_plano;
  static constexpr const clause* is_of_type = &Es_Plano_pre_1;  ///< where a change names the type

  /// The case of potencia.def.1. It outlives the scene.
  static Potencia potencia(const Escena& escena, const Elemento& e);
  /// The case of puntos_de_elemento.def.1.
  static Puntos puntos(const Escena& escena, const Elemento& e);
};

}  // namespace durero::model
