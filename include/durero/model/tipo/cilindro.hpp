#pragma once
/// What the text says of a cylinder: its operations, the error of a removal that means another type, and its points.

#include "durero/model/operaciones_errors.hpp"
#include "durero/model/schema.hpp"

namespace durero::model {

// Agregar_Cilindro

inline constexpr clause Agregar_Cilindro_pre_1{"Agregar_Cilindro.pre.1", "t? = soy_cilindro"};
inline constexpr clause Agregar_Cilindro_pre_2{"Agregar_Cilindro.pre.2", "radio? ∈ Rmas"};
inline constexpr clause Agregar_Cilindro_pre_3{"Agregar_Cilindro.pre.3", "vector? ∈ Unitario"};
inline constexpr clause Agregar_Cilindro_pre_4{"Agregar_Cilindro.pre.4", "altura? ∈ Rmas"};
inline constexpr clause Agregar_Cilindro_post_1{"Agregar_Cilindro.post.1", "mi_centro' = mi_centro ∪ { e? ↦ centro? }"};
inline constexpr clause Agregar_Cilindro_post_2{"Agregar_Cilindro.post.2", "mi_radio' = mi_radio ∪ { e? ↦ radio? }"};
inline constexpr clause Agregar_Cilindro_post_3{"Agregar_Cilindro.post.3", "mi_vector' = mi_vector ∪ { e? ↦ vector? }"};
inline constexpr clause Agregar_Cilindro_post_4{"Agregar_Cilindro.post.4", "mi_altura' = mi_altura ∪ { e? ↦ altura? }"};
inline constexpr clause Agregar_Cilindro_post_5{"Agregar_Cilindro.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Agregar_Cilindro_post_6{"Agregar_Cilindro.post.6", "mi_vertices' = mi_vertices"};
inline constexpr clause Agregar_Cilindro_post_7{"Agregar_Cilindro.post.7", "r! = cilindro_agregado"};

struct Agregar_Cilindro {
  Elemento e;
  Punto centro;
  double radio;
  Vector vector;
  double altura;
  Tipo t = tipo;

  static constexpr Tipo tipo = Tipo::soy_cilindro;
  static constexpr Respuesta answer = Respuesta::cilindro_agregado;
  static constexpr std::string_view schema = "Agregar_Cilindro";
  static constexpr std::string_view total = "Agregar_Cilindro_Total";  ///< Agregar_Cilindro_Total.def.1

  static constexpr const clause* is_of_type = &Agregar_Cilindro_pre_1;
  static constexpr std::tuple requirements{Required<Rmas, Radio_No_Positivo>{&Agregar_Cilindro_pre_2},
                                           Required<Unitario, Vector_No_Unitario>{&Agregar_Cilindro_pre_3},
                                           Required<Rmas, Altura_No_Positiva>{&Agregar_Cilindro_pre_4}};
  static constexpr std::tuple effects{Joined<&Escena::mi_centro, &Agregar_Cilindro::centro>{&Agregar_Cilindro_post_1},
                                      Joined<&Escena::mi_radio, &Agregar_Cilindro::radio>{&Agregar_Cilindro_post_2},
                                      Joined<&Escena::mi_vector, &Agregar_Cilindro::vector>{&Agregar_Cilindro_post_3},
                                      Joined<&Escena::mi_altura, &Agregar_Cilindro::altura>{&Agregar_Cilindro_post_4},
                                      Kept<&Escena::mi_proporcion>{&Agregar_Cilindro_post_5},
                                      Kept<&Escena::mi_vertices>{&Agregar_Cilindro_post_6}};
  static constexpr const clause* answers = &Agregar_Cilindro_post_7;
};

// Es_Cilindro

inline constexpr clause Es_Cilindro_pre_1{"Es_Cilindro.pre.1", "e? ↦ soy_cilindro ∈ de_que_tipo"};

// No_Es_Cilindro

inline constexpr clause No_Es_Cilindro_pre_1{"No_Es_Cilindro.pre.1", "e? ∈ elementos"};
inline constexpr clause No_Es_Cilindro_pre_2{"No_Es_Cilindro.pre.2", "de_que_tipo(e?) ≠ soy_cilindro"};
inline constexpr clause No_Es_Cilindro_post_1{"No_Es_Cilindro.post.1", "r! = tipo_incorrecto"};

struct No_Es_Cilindro {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_cilindro;
  static constexpr Respuesta answer = Respuesta::tipo_incorrecto;
  static constexpr const clause *exists = &No_Es_Cilindro_pre_1, *is_of_another_type = &No_Es_Cilindro_pre_2,
                                *answers = &No_Es_Cilindro_post_1;
};

// Eliminar_Cilindro

inline constexpr clause Eliminar_Cilindro_pre_1{"Eliminar_Cilindro.pre.1", "de_que_tipo(e?) = soy_cilindro"};
inline constexpr clause Eliminar_Cilindro_post_1{"Eliminar_Cilindro.post.1", "mi_centro' = { e? } ⩤ mi_centro"};
inline constexpr clause Eliminar_Cilindro_post_2{"Eliminar_Cilindro.post.2", "mi_radio' = { e? } ⩤ mi_radio"};
inline constexpr clause Eliminar_Cilindro_post_3{"Eliminar_Cilindro.post.3", "mi_vector' = { e? } ⩤ mi_vector"};
inline constexpr clause Eliminar_Cilindro_post_4{"Eliminar_Cilindro.post.4", "mi_altura' = { e? } ⩤ mi_altura"};
inline constexpr clause Eliminar_Cilindro_post_5{"Eliminar_Cilindro.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Eliminar_Cilindro_post_6{"Eliminar_Cilindro.post.6", "mi_vertices' = mi_vertices"};
inline constexpr clause Eliminar_Cilindro_post_7{"Eliminar_Cilindro.post.7", "r! = cilindro_eliminado"};

struct Eliminar_Cilindro {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_cilindro;
  static constexpr Respuesta answer = Respuesta::cilindro_eliminado;
  static constexpr std::string_view schema = "Eliminar_Cilindro";
  static constexpr std::string_view total = "Eliminar_Cilindro_Total";  ///< Eliminar_Cilindro_Total.def.1
  using Denial = No_Es_Cilindro;

  static constexpr const clause* is_of_type = &Eliminar_Cilindro_pre_1;
  static constexpr std::tuple effects{
      Dropped<&Escena::mi_centro>{&Eliminar_Cilindro_post_1},  Dropped<&Escena::mi_radio>{&Eliminar_Cilindro_post_2},
      Dropped<&Escena::mi_vector>{&Eliminar_Cilindro_post_3},  Dropped<&Escena::mi_altura>{&Eliminar_Cilindro_post_4},
      Kept<&Escena::mi_proporcion>{&Eliminar_Cilindro_post_5}, Kept<&Escena::mi_vertices>{&Eliminar_Cilindro_post_6}};
  static constexpr const clause* answers = &Eliminar_Cilindro_post_7;
};

// Points

/// The power of w with respect to an unbounded cylinder (potencia_cilindro.def.1).
Surd potencia_cilindro(const ExactPoint& w, const Punto& centro, const Rmas& radio, const Vector& dir);

/// The points of a cylinder, open, with both its rims (puntos_cilindro.def.1).
Puntos puntos_cilindro(const Punto& centro, const Rmas& radio, const Vector& dir, const Rmas& h);

/// What the definitions by cases of the text say of a cylinder.
struct Cilindro {
  using Addition = Agregar_Cilindro;
  using Removal = Eliminar_Cilindro;
  static constexpr Tipo tipo = Tipo::soy_cilindro;
  static constexpr const clause* is_of_type = &Es_Cilindro_pre_1;  ///< where a change names the type

  /// The case of potencia.def.1. It outlives the scene.
  static Potencia potencia(const Escena& escena, const Elemento& e);
  /// The case of puntos_de_elemento.def.1.
  static Puntos puntos(const Escena& escena, const Elemento& e);
};

}  // namespace durero::model
