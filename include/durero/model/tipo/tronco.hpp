#pragma once
/// What the text says of a truncated cone: its operations, the error of a removal that means another type, and its
/// points.

#include "durero/model/operaciones_errors.hpp"
#include "durero/model/schema.hpp"

namespace durero::model {

// Agregar_Tronco

inline constexpr clause Agregar_Tronco_pre_1{"Agregar_Tronco.pre.1", "t? = soy_tronco"};
inline constexpr clause Agregar_Tronco_pre_2{"Agregar_Tronco.pre.2", "radio? ∈ Rmas"};
inline constexpr clause Agregar_Tronco_pre_3{"Agregar_Tronco.pre.3", "proporcion? ∈ Rmas"};
inline constexpr clause Agregar_Tronco_pre_4{"Agregar_Tronco.pre.4", "vector? ∈ Unitario"};
inline constexpr clause Agregar_Tronco_pre_5{"Agregar_Tronco.pre.5", "altura? ∈ Rmas"};
inline constexpr clause Agregar_Tronco_post_1{"Agregar_Tronco.post.1", "mi_centro' = mi_centro ∪ { e? ↦ centro? }"};
inline constexpr clause Agregar_Tronco_post_2{"Agregar_Tronco.post.2", "mi_radio' = mi_radio ∪ { e? ↦ radio? }"};
inline constexpr clause Agregar_Tronco_post_3{"Agregar_Tronco.post.3", "mi_vector' = mi_vector ∪ { e? ↦ vector? }"};
inline constexpr clause Agregar_Tronco_post_4{"Agregar_Tronco.post.4", "mi_altura' = mi_altura ∪ { e? ↦ altura? }"};
inline constexpr clause Agregar_Tronco_post_5{"Agregar_Tronco.post.5",
                                              "mi_proporcion' = mi_proporcion ∪ { e? ↦ proporcion? }"};
inline constexpr clause Agregar_Tronco_post_6{"Agregar_Tronco.post.6", "mi_vertices' = mi_vertices"};
inline constexpr clause Agregar_Tronco_post_7{"Agregar_Tronco.post.7", "r! = tronco_agregado"};

struct Agregar_Tronco {
  Elemento e;
  Punto centro;
  double radio;
  double proporcion;
  Vector vector;
  double altura;
  Tipo t = tipo;

  static constexpr Tipo tipo = Tipo::soy_tronco;
  static constexpr Respuesta answer = Respuesta::tronco_agregado;
  static constexpr std::string_view schema = "Agregar_Tronco";
  static constexpr std::string_view total = "Agregar_Tronco_Total";  ///< Agregar_Tronco_Total.def.1

  static constexpr const clause* is_of_type = &Agregar_Tronco_pre_1;
  static constexpr std::tuple requirements{Required<Rmas, Radio_No_Positivo>{&Agregar_Tronco_pre_2},
                                           Required<Rmas, Proporcion_No_Positiva>{&Agregar_Tronco_pre_3},
                                           Required<Unitario, Vector_No_Unitario>{&Agregar_Tronco_pre_4},
                                           Required<Rmas, Altura_No_Positiva>{&Agregar_Tronco_pre_5}};
  static constexpr std::tuple effects{
      Joined<&Escena::mi_centro, &Agregar_Tronco::centro>{&Agregar_Tronco_post_1},
      Joined<&Escena::mi_radio, &Agregar_Tronco::radio>{&Agregar_Tronco_post_2},
      Joined<&Escena::mi_vector, &Agregar_Tronco::vector>{&Agregar_Tronco_post_3},
      Joined<&Escena::mi_altura, &Agregar_Tronco::altura>{&Agregar_Tronco_post_4},
      Joined<&Escena::mi_proporcion, &Agregar_Tronco::proporcion>{&Agregar_Tronco_post_5},
      Kept<&Escena::mi_vertices>{&Agregar_Tronco_post_6}};
  static constexpr const clause* answers = &Agregar_Tronco_post_7;
};

// Es_Tronco

inline constexpr clause Es_Tronco_pre_1{"Es_Tronco.pre.1", "e? ↦ soy_tronco ∈ de_que_tipo"};

// No_Es_Tronco

inline constexpr clause No_Es_Tronco_pre_1{"No_Es_Tronco.pre.1", "e? ∈ elementos"};
inline constexpr clause No_Es_Tronco_pre_2{"No_Es_Tronco.pre.2", "de_que_tipo(e?) ≠ soy_tronco"};
inline constexpr clause No_Es_Tronco_post_1{"No_Es_Tronco.post.1", "r! = tipo_incorrecto"};

struct No_Es_Tronco {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_tronco;
  static constexpr Respuesta answer = Respuesta::tipo_incorrecto;
  static constexpr const clause *exists = &No_Es_Tronco_pre_1, *is_of_another_type = &No_Es_Tronco_pre_2,
                                *answers = &No_Es_Tronco_post_1;
};

// Eliminar_Tronco

inline constexpr clause Eliminar_Tronco_pre_1{"Eliminar_Tronco.pre.1", "de_que_tipo(e?) = soy_tronco"};
inline constexpr clause Eliminar_Tronco_post_1{"Eliminar_Tronco.post.1", "mi_centro' = { e? } ⩤ mi_centro"};
inline constexpr clause Eliminar_Tronco_post_2{"Eliminar_Tronco.post.2", "mi_radio' = { e? } ⩤ mi_radio"};
inline constexpr clause Eliminar_Tronco_post_3{"Eliminar_Tronco.post.3", "mi_vector' = { e? } ⩤ mi_vector"};
inline constexpr clause Eliminar_Tronco_post_4{"Eliminar_Tronco.post.4", "mi_altura' = { e? } ⩤ mi_altura"};
inline constexpr clause Eliminar_Tronco_post_5{"Eliminar_Tronco.post.5", "mi_proporcion' = { e? } ⩤ mi_proporcion"};
inline constexpr clause Eliminar_Tronco_post_6{"Eliminar_Tronco.post.6", "mi_vertices' = mi_vertices"};
inline constexpr clause Eliminar_Tronco_post_7{"Eliminar_Tronco.post.7", "r! = tronco_eliminado"};

struct Eliminar_Tronco {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_tronco;
  static constexpr Respuesta answer = Respuesta::tronco_eliminado;
  static constexpr std::string_view schema = "Eliminar_Tronco";
  static constexpr std::string_view total = "Eliminar_Tronco_Total";  ///< Eliminar_Tronco_Total.def.1
  using Denial = No_Es_Tronco;

  static constexpr const clause* is_of_type = &Eliminar_Tronco_pre_1;
  static constexpr std::tuple effects{
      Dropped<&Escena::mi_centro>{&Eliminar_Tronco_post_1},     Dropped<&Escena::mi_radio>{&Eliminar_Tronco_post_2},
      Dropped<&Escena::mi_vector>{&Eliminar_Tronco_post_3},     Dropped<&Escena::mi_altura>{&Eliminar_Tronco_post_4},
      Dropped<&Escena::mi_proporcion>{&Eliminar_Tronco_post_5}, Kept<&Escena::mi_vertices>{&Eliminar_Tronco_post_6}};
  static constexpr const clause* answers = &Eliminar_Tronco_post_7;
};

// Points

/// The power of w with respect to the unbounded double cone that a truncated cone is a part of (potencia_tronco.def.1).
Surd potencia_tronco(const ExactPoint& w, const Punto& centro, const Rmas& radio, const Rmas& prop, const Vector& dir,
                     const Rmas& h);

/// The points of a truncated cone, open, with both its rims (puntos_tronco.def.1).
Puntos puntos_tronco(const Punto& centro, const Rmas& radio, const Rmas& prop, const Vector& dir, const Rmas& h);

/// What the definitions by cases of the text say of a truncated cone.
struct Tronco {
  using Addition = Agregar_Tronco;
  using Removal = Eliminar_Tronco;
  static constexpr Tipo tipo = Tipo::soy_tronco;
  static constexpr const clause* is_of_type = &Es_Tronco_pre_1;  ///< where a change names the type

  /// The case of potencia.def.1. It outlives the scene.
  static Potencia potencia(const Escena& escena, const Elemento& e);
  /// The case of puntos_de_elemento.def.1.
  static Puntos puntos(const Escena& escena, const Elemento& e);
};

}  // namespace durero::model
