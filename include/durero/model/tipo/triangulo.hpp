#pragma once
/// What the text says of a triangle: its operations, the error of a removal that means another type, and its points.

#include "durero/model/operaciones_errors.hpp"
#include "durero/model/schema.hpp"

namespace durero::model {

// Agregar_Triangulo

inline constexpr clause Agregar_Triangulo_pre_1{"Agregar_Triangulo.pre.1", "t? = soy_triangulo"};
inline constexpr clause Agregar_Triangulo_pre_2{"Agregar_Triangulo.pre.2", "vertices? ∈ Vertices"};
inline constexpr clause Agregar_Triangulo_post_1{"Agregar_Triangulo.post.1", "mi_centro' = mi_centro"};
inline constexpr clause Agregar_Triangulo_post_2{"Agregar_Triangulo.post.2", "mi_radio' = mi_radio"};
inline constexpr clause Agregar_Triangulo_post_3{"Agregar_Triangulo.post.3", "mi_vector' = mi_vector"};
inline constexpr clause Agregar_Triangulo_post_4{"Agregar_Triangulo.post.4", "mi_altura' = mi_altura"};
inline constexpr clause Agregar_Triangulo_post_5{"Agregar_Triangulo.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Agregar_Triangulo_post_6{"Agregar_Triangulo.post.6",
                                                 "mi_vertices' = mi_vertices ∪ { e? ↦ vertices? }"};
inline constexpr clause Agregar_Triangulo_post_7{"Agregar_Triangulo.post.7", "r! = triangulo_agregado"};

struct Agregar_Triangulo {
  Elemento e;
  Terna vertices;
  Tipo t = tipo;

  static constexpr Tipo tipo = Tipo::soy_triangulo;
  static constexpr Respuesta answer = Respuesta::triangulo_agregado;
  static constexpr std::string_view schema = "Agregar_Triangulo";
  static constexpr std::string_view total = "Agregar_Triangulo_Total";  ///< Agregar_Triangulo_Total.def.1

  static constexpr const clause* is_of_type = &Agregar_Triangulo_pre_1;
  static constexpr std::tuple requirements{Required<Vertices, Vertices_Alineados>{&Agregar_Triangulo_pre_2}};
  static constexpr std::tuple effects{
      Kept<&Escena::mi_centro>{&Agregar_Triangulo_post_1},
      Kept<&Escena::mi_radio>{&Agregar_Triangulo_post_2},
      Kept<&Escena::mi_vector>{&Agregar_Triangulo_post_3},
      Kept<&Escena::mi_altura>{&Agregar_Triangulo_post_4},
      Kept<&Escena::mi_proporcion>{&Agregar_Triangulo_post_5},
      Joined<&Escena::mi_vertices, &Agregar_Triangulo::vertices>{&Agregar_Triangulo_post_6}};
  static constexpr const clause* answers = &Agregar_Triangulo_post_7;
};

// Es_Triangulo

inline constexpr clause Es_Triangulo_pre_1{"Es_Triangulo.pre.1", "e? ↦ soy_triangulo ∈ de_que_tipo"};

// No_Es_Triangulo

inline constexpr clause No_Es_Triangulo_pre_1{"No_Es_Triangulo.pre.1", "e? ∈ elementos"};
inline constexpr clause No_Es_Triangulo_pre_2{"No_Es_Triangulo.pre.2", "de_que_tipo(e?) ≠ soy_triangulo"};
inline constexpr clause No_Es_Triangulo_post_1{"No_Es_Triangulo.post.1", "r! = tipo_incorrecto"};

struct No_Es_Triangulo {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_triangulo;
  static constexpr Respuesta answer = Respuesta::tipo_incorrecto;
  static constexpr const clause *exists = &No_Es_Triangulo_pre_1, *is_of_another_type = &No_Es_Triangulo_pre_2,
                                *answers = &No_Es_Triangulo_post_1;
};

// Eliminar_Triangulo

inline constexpr clause Eliminar_Triangulo_pre_1{"Eliminar_Triangulo.pre.1", "de_que_tipo(e?) = soy_triangulo"};
inline constexpr clause Eliminar_Triangulo_post_1{"Eliminar_Triangulo.post.1", "mi_centro' = mi_centro"};
inline constexpr clause Eliminar_Triangulo_post_2{"Eliminar_Triangulo.post.2", "mi_radio' = mi_radio"};
inline constexpr clause Eliminar_Triangulo_post_3{"Eliminar_Triangulo.post.3", "mi_vector' = mi_vector"};
inline constexpr clause Eliminar_Triangulo_post_4{"Eliminar_Triangulo.post.4", "mi_altura' = mi_altura"};
inline constexpr clause Eliminar_Triangulo_post_5{"Eliminar_Triangulo.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Eliminar_Triangulo_post_6{"Eliminar_Triangulo.post.6", "mi_vertices' = { e? } ⩤ mi_vertices"};
inline constexpr clause Eliminar_Triangulo_post_7{"Eliminar_Triangulo.post.7", "r! = triangulo_eliminado"};

struct Eliminar_Triangulo {
  Elemento e;

  static constexpr Tipo tipo = Tipo::soy_triangulo;
  static constexpr Respuesta answer = Respuesta::triangulo_eliminado;
  static constexpr std::string_view schema = "Eliminar_Triangulo";
  static constexpr std::string_view total = "Eliminar_Triangulo_Total";  ///< Eliminar_Triangulo_Total.def.1
  using Denial = No_Es_Triangulo;

  static constexpr const clause* is_of_type = &Eliminar_Triangulo_pre_1;
  static constexpr std::tuple effects{Kept<&Escena::mi_centro>{&Eliminar_Triangulo_post_1},
                                      Kept<&Escena::mi_radio>{&Eliminar_Triangulo_post_2},
                                      Kept<&Escena::mi_vector>{&Eliminar_Triangulo_post_3},
                                      Kept<&Escena::mi_altura>{&Eliminar_Triangulo_post_4},
                                      Kept<&Escena::mi_proporcion>{&Eliminar_Triangulo_post_5},
                                      Dropped<&Escena::mi_vertices>{&Eliminar_Triangulo_post_6}};
  static constexpr const clause* answers = &Eliminar_Triangulo_post_7;
};

// Points

/// The power of w with respect to a triangle: the volume over its edges (potencia_triangulo.def.1).
Surd potencia_triangulo(const ExactPoint& w, const Terna& v);

/// (q − p)·(s − r) (escalar.def.1)
Surd escalar(const ExactPoint& p, const ExactPoint& q, const ExactPoint& r, const ExactPoint& s);

/// On which side of the line through a and b, in the plane of the three, w lies: positive where c does (lado.def.1).
Surd lado(const ExactPoint& w, const Punto& a, const Punto& b, const Punto& c);

/// The prism over a triangle (prisma.def.1).
Puntos prisma(const Terna& v);

/// The points of a triangle, with its edges and its vertices (puntos_triangulo.def.1).
Puntos puntos_triangulo(const Terna& v);

/// What the definitions by cases of the text say of a triangle.
struct Triangulo {
  using Addition = Agregar_Triangulo;
  using Removal = Eliminar_Triangulo;
  static constexpr Tipo tipo = Tipo::soy_triangulo;
  static constexpr const clause* is_of_type = &Es_Triangulo_pre_1;  ///< where a change names the type

  /// The case of potencia.def.1. It outlives the scene.
  static Potencia potencia(const Escena& escena, const Elemento& e);
  /// The case of puntos_de_elemento.def.1.
  static Puntos puntos(const Escena& escena, const Elemento& e);
};

}  // namespace durero::model
