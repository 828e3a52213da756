#pragma once
/// What the text says of a sphere: its operations, the error of a removal that means another type, and its points.

#include "durero/model/operaciones_errors.hpp"
#include "durero/model/schema.hpp"

namespace durero::model {

// Agregar_Esfera

inline constexpr clause Agregar_Esfera_pre_1{"Agregar_Esfera.pre.1", "t? = soy_esfera"};
inline constexpr clause Agregar_Esfera_pre_2{"Agregar_Esfera.pre.2", "radio? ∈ Rmas"};
inline constexpr clause Agregar_Esfera_post_1{"Agregar_Esfera.post.1", "mi_centro' = mi_centro ∪ { e? ↦ centro? }"};
inline constexpr clause Agregar_Esfera_post_2{"Agregar_Esfera.post.2", "mi_radio' = mi_radio ∪ { e? ↦ radio? }"};
inline constexpr clause Agregar_Esfera_post_3{"Agregar_Esfera.post.3", "mi_vector' = mi_vector"};
inline constexpr clause Agregar_Esfera_post_4{"Agregar_Esfera.post.4", "mi_altura' = mi_altura"};
inline constexpr clause Agregar_Esfera_post_5{"Agregar_Esfera.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Agregar_Esfera_post_6{"Agregar_Esfera.post.6", "mi_vertices' = mi_vertices"};
inline constexpr clause Agregar_Esfera_post_7{"Agregar_Esfera.post.7", "r! = esfera_agregada"};

struct Agregar_Esfera {
  Elemento e;
  Punto centro;
  double radio;
  Tipo t = tipo;

  static constexpr Tipo tipo = Tipo::soy_esfera;
  static constexpr Respuesta answer = Respuesta::esfera_agregada;
  static constexpr std::string_view schema = "Agregar_Esfera";
  static constexpr std::string_view total = "Agregar_Esfera_Total";  ///< Agregar_Esfera_Total.def.1

  static constexpr const clause* is_of_type = &Agregar_Esfera_pre_1;
  static constexpr std::tuple requirements{Required<Rmas, Radio_No_Positivo>{&Agregar_Esfera_pre_2}};
  static constexpr std::tuple effects{Joined<&Escena::mi_centro, &Agregar_Esfera::centro>{&Agregar_Esfera_post_1},
                                      Joined<&Escena::mi_radio, &Agregar_Esfera::radio>{&Agregar_Esfera_post_2},
                                      Kept<&Escena::mi_vector>{&Agregar_Esfera_post_3},
                                      Kept<&Escena::mi_altura>{&Agregar_Esfera_post_4},
                                      Kept<&Escena::mi_proporcion>{&Agregar_Esfera_post_5},
                                      Kept<&Escena::mi_vertices>{&Agregar_Esfera_post_6}};
  static constexpr const clause* answers = &Agregar_Esfera_post_7;
};

// Es_Esfera

inline constexpr clause Es_Esfera_pre_1{"Es_Esfera.pre.1", "e? ↦ soy_esfera ∈ de_que_tipo"};

// No_Es_Esfera

inline constexpr clause No_Es_Esfera_pre_1{"No_Es_Esfera.pre.1", "e? ∈ elementos"};
inline constexpr clause No_Es_Esfera_pre_2{"No_Es_Esfera.pre.2", "de_que_tipo(e?) ≠ soy_esfera"};
inline constexpr clause No_Es_Esfera_post_1{"No_Es_Esfera.post.1", "r! = tipo_incorrecto"};

struct No_Es_Esfera {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_esfera;
  static constexpr Respuesta answer = Respuesta::tipo_incorrecto;
  static constexpr const clause *exists = &No_Es_Esfera_pre_1, *is_of_another_type = &No_Es_Esfera_pre_2,
                                *answers = &No_Es_Esfera_post_1;
};

// Eliminar_Esfera

inline constexpr clause Eliminar_Esfera_pre_1{"Eliminar_Esfera.pre.1", "de_que_tipo(e?) = soy_esfera"};
inline constexpr clause Eliminar_Esfera_post_1{"Eliminar_Esfera.post.1", "mi_centro' = { e? } ⩤ mi_centro"};
inline constexpr clause Eliminar_Esfera_post_2{"Eliminar_Esfera.post.2", "mi_radio' = { e? } ⩤ mi_radio"};
inline constexpr clause Eliminar_Esfera_post_3{"Eliminar_Esfera.post.3", "mi_vector' = mi_vector"};
inline constexpr clause Eliminar_Esfera_post_4{"Eliminar_Esfera.post.4", "mi_altura' = mi_altura"};
inline constexpr clause Eliminar_Esfera_post_5{"Eliminar_Esfera.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Eliminar_Esfera_post_6{"Eliminar_Esfera.post.6", "mi_vertices' = mi_vertices"};
inline constexpr clause Eliminar_Esfera_post_7{"Eliminar_Esfera.post.7", "r! = esfera_eliminada"};

struct Eliminar_Esfera {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_esfera;
  static constexpr Respuesta answer = Respuesta::esfera_eliminada;
  static constexpr std::string_view schema = "Eliminar_Esfera";
  static constexpr std::string_view total = "Eliminar_Esfera_Total";  ///< Eliminar_Esfera_Total.def.1
  using Denial = No_Es_Esfera;

  static constexpr const clause* is_of_type = &Eliminar_Esfera_pre_1;
  static constexpr std::tuple effects{
      Dropped<&Escena::mi_centro>{&Eliminar_Esfera_post_1},  Dropped<&Escena::mi_radio>{&Eliminar_Esfera_post_2},
      Kept<&Escena::mi_vector>{&Eliminar_Esfera_post_3},     Kept<&Escena::mi_altura>{&Eliminar_Esfera_post_4},
      Kept<&Escena::mi_proporcion>{&Eliminar_Esfera_post_5}, Kept<&Escena::mi_vertices>{&Eliminar_Esfera_post_6}};
  static constexpr const clause* answers = &Eliminar_Esfera_post_7;
};

// Points

/// The power of w with respect to a sphere, zero exactly on it (potencia_esfera.def.1).
Surd potencia_esfera(const ExactPoint& w, const Punto& centro, const Rmas& radio);

/// The points of a sphere (puntos_esfera.def.1).
Puntos puntos_esfera(const Punto& centro, const Rmas& radio);

/// What the definitions by cases of the text say of a sphere.
struct Esfera {
  using Addition = Agregar_Esfera;
  using Removal = Eliminar_Esfera;
  static constexpr Tipo tipo = Tipo::soy_esfera;
  static constexpr const clause* is_of_type = &Es_Esfera_pre_1;  ///< where a change names the type

  /// The case of potencia.def.1. It outlives the scene.
  static Potencia potencia(const Escena& escena, const Elemento& e);
  /// The case of puntos_de_elemento.def.1.
  static Puntos puntos(const Escena& escena, const Elemento& e);
};

}  // namespace durero::model
