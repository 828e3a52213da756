#pragma once
/// What the text says of a cone: its operations, the error of a removal that means another type, and its points.

#include "durero/model/operaciones_errors.hpp"
#include "durero/model/schema.hpp"

namespace durero::model {

// Agregar_Cono

inline constexpr clause Agregar_Cono_pre_1{"Agregar_Cono.pre.1", "t? = soy_cono"};
inline constexpr clause Agregar_Cono_pre_2{"Agregar_Cono.pre.2", "proporcion? ∈ Rmas"};
inline constexpr clause Agregar_Cono_pre_3{"Agregar_Cono.pre.3", "vector? ∈ Unitario"};
inline constexpr clause Agregar_Cono_pre_4{"Agregar_Cono.pre.4", "altura? ∈ Rmas"};
inline constexpr clause Agregar_Cono_post_1{"Agregar_Cono.post.1", "mi_centro' = mi_centro ∪ { e? ↦ centro? }"};
inline constexpr clause Agregar_Cono_post_2{"Agregar_Cono.post.2", "mi_radio' = mi_radio"};
inline constexpr clause Agregar_Cono_post_3{"Agregar_Cono.post.3", "mi_vector' = mi_vector ∪ { e? ↦ vector? }"};
inline constexpr clause Agregar_Cono_post_4{"Agregar_Cono.post.4", "mi_altura' = mi_altura ∪ { e? ↦ altura? }"};
inline constexpr clause Agregar_Cono_post_5{"Agregar_Cono.post.5",
                                            "mi_proporcion' = mi_proporcion ∪ { e? ↦ proporcion? }"};
inline constexpr clause Agregar_Cono_post_6{"Agregar_Cono.post.6", "mi_vertices' = mi_vertices"};
inline constexpr clause Agregar_Cono_post_7{"Agregar_Cono.post.7", "r! = cono_agregado"};

struct Agregar_Cono {
  Elemento e;
  Punto centro;
  double proporcion;
  Vector vector;
  double altura;
  Tipo t = tipo;

  static constexpr Tipo tipo = Tipo::soy_cono;
  static constexpr Respuesta answer = Respuesta::cono_agregado;
  static constexpr std::string_view schema = "Agregar_Cono";
  static constexpr std::string_view total = "Agregar_Cono_Total";  ///< Agregar_Cono_Total.def.1

  static constexpr const clause* is_of_type = &Agregar_Cono_pre_1;
  static constexpr std::tuple requirements{Required<Rmas, Proporcion_No_Positiva>{&Agregar_Cono_pre_2},
                                           Required<Unitario, Vector_No_Unitario>{&Agregar_Cono_pre_3},
                                           Required<Rmas, Altura_No_Positiva>{&Agregar_Cono_pre_4}};
  static constexpr std::tuple effects{Joined<&Escena::mi_centro, &Agregar_Cono::centro>{&Agregar_Cono_post_1},
                                      Kept<&Escena::mi_radio>{&Agregar_Cono_post_2},
                                      Joined<&Escena::mi_vector, &Agregar_Cono::vector>{&Agregar_Cono_post_3},
                                      Joined<&Escena::mi_altura, &Agregar_Cono::altura>{&Agregar_Cono_post_4},
                                      Joined<&Escena::mi_proporcion, &Agregar_Cono::proporcion>{&Agregar_Cono_post_5},
                                      Kept<&Escena::mi_vertices>{&Agregar_Cono_post_6}};
  static constexpr const clause* answers = &Agregar_Cono_post_7;
};

// Es_Cono

inline constexpr clause Es_Cono_pre_1{"Es_Cono.pre.1", "e? ↦ soy_cono ∈ de_que_tipo"};

// No_Es_Cono

inline constexpr clause No_Es_Cono_pre_1{"No_Es_Cono.pre.1", "e? ∈ elementos"};
inline constexpr clause No_Es_Cono_pre_2{"No_Es_Cono.pre.2", "de_que_tipo(e?) ≠ soy_cono"};
inline constexpr clause No_Es_Cono_post_1{"No_Es_Cono.post.1", "r! = tipo_incorrecto"};

struct No_Es_Cono {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_cono;
  static constexpr Respuesta answer = Respuesta::tipo_incorrecto;
  static constexpr const clause *exists = &No_Es_Cono_pre_1, *is_of_another_type = &No_Es_Cono_pre_2,
                                *answers = &No_Es_Cono_post_1;
};

// Eliminar_Cono

inline constexpr clause Eliminar_Cono_pre_1{"Eliminar_Cono.pre.1", "de_que_tipo(e?) = soy_cono"};
inline constexpr clause Eliminar_Cono_post_1{"Eliminar_Cono.post.1", "mi_centro' = { e? } ⩤ mi_centro"};
inline constexpr clause Eliminar_Cono_post_2{"Eliminar_Cono.post.2", "mi_radio' = mi_radio"};
inline constexpr clause Eliminar_Cono_post_3{"Eliminar_Cono.post.3", "mi_vector' = { e? } ⩤ mi_vector"};
inline constexpr clause Eliminar_Cono_post_4{"Eliminar_Cono.post.4", "mi_altura' = { e? } ⩤ mi_altura"};
inline constexpr clause Eliminar_Cono_post_5{"Eliminar_Cono.post.5", "mi_proporcion' = { e? } ⩤ mi_proporcion"};
inline constexpr clause Eliminar_Cono_post_6{"Eliminar_Cono.post.6", "mi_vertices' = mi_vertices"};
inline constexpr clause Eliminar_Cono_post_7{"Eliminar_Cono.post.7", "r! = cono_eliminado"};

struct Eliminar_Cono {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_cono;
  static constexpr Respuesta answer = Respuesta::cono_eliminado;
  static constexpr std::string_view schema = "Eliminar_Cono";
  static constexpr std::string_view total = "Eliminar_Cono_Total";  ///< Eliminar_Cono_Total.def.1
  using Denial = No_Es_Cono;

  static constexpr const clause* is_of_type = &Eliminar_Cono_pre_1;
  static constexpr std::tuple effects{
      Dropped<&Escena::mi_centro>{&Eliminar_Cono_post_1},     Kept<&Escena::mi_radio>{&Eliminar_Cono_post_2},
      Dropped<&Escena::mi_vector>{&Eliminar_Cono_post_3},     Dropped<&Escena::mi_altura>{&Eliminar_Cono_post_4},
      Dropped<&Escena::mi_proporcion>{&Eliminar_Cono_post_5}, Kept<&Escena::mi_vertices>{&Eliminar_Cono_post_6}};
  static constexpr const clause* answers = &Eliminar_Cono_post_7;
};

// Points

/// The power of w with respect to an unbounded double cone (potencia_cono.def.1).
Surd potencia_cono(const ExactPoint& w, const Punto& centro, const Rmas& prop, const Vector& dir, const Rmas& h);

/// The points of a cone, open, with its rim and its apex (puntos_cono.def.1).
Puntos puntos_cono(const Punto& centro, const Rmas& prop, const Vector& dir, const Rmas& h);

/// What the definitions by cases of the text say of a cone.
struct Cono {
  using Addition = Agregar_Cono;
  using Removal = Eliminar_Cono;
  static constexpr Tipo tipo = Tipo::soy_cono;
  static constexpr const clause* is_of_type = &Es_Cono_pre_1;  ///< where a change names the type

  /// The case of potencia.def.1. It outlives the scene.
  static Potencia potencia(const Escena& escena, const Elemento& e);
  /// The case of puntos_de_elemento.def.1.
  static Puntos puntos(const Escena& escena, const Elemento& e);
};

}  // namespace durero::model
