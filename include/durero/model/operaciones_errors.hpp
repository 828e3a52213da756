#pragma once
/// What can go wrong (spec/operaciones.tex): one schema for each error, with its answer. The scene stays as it is
/// (Ξ Escena). clauses(in, escena, r, visit) hands `visit(clause, holds)` what the text says of an error, in its order.
/// The errors that name one type stand with it, in model/tipo/.

#include "durero/model/escena.hpp"

namespace durero::model {

using contract::clause;

struct Elemento_Ya_Existe {
  Elemento e;
  static constexpr Respuesta answer = Respuesta::elemento_ya_existe;
};

inline constexpr clause Elemento_Ya_Existe_pre_1{"Elemento_Ya_Existe.pre.1", "e? ∈ elementos"};
inline constexpr clause Elemento_Ya_Existe_post_1{"Elemento_Ya_Existe.post.1", "r! = elemento_ya_existe"};

/// What the text says of it.
template <class Visit>
void clauses(const Elemento_Ya_Existe& in, const Escena& s, Respuesta r, Visit&& visit) {
  visit(Elemento_Ya_Existe_pre_1, [&] { return s.elementos.contains(in.e); });
  visit(Elemento_Ya_Existe_post_1, [&] { return r == Respuesta::elemento_ya_existe; });
}

struct Elemento_No_Existe {
  Elemento e;
  static constexpr Respuesta answer = Respuesta::elemento_no_existe;
};

inline constexpr clause Elemento_No_Existe_pre_1{"Elemento_No_Existe.pre.1", "e? ∉ elementos"};
inline constexpr clause Elemento_No_Existe_post_1{"Elemento_No_Existe.post.1", "r! = elemento_no_existe"};

/// What the text says of it.
template <class Visit>
void clauses(const Elemento_No_Existe& in, const Escena& s, Respuesta r, Visit&& visit) {
  visit(Elemento_No_Existe_pre_1, [&] { return !s.elementos.contains(in.e); });
  visit(Elemento_No_Existe_post_1, [&] { return r == Respuesta::elemento_no_existe; });
}

struct Radio_No_Positivo {
  double radio;
  static constexpr auto component = &Escena::mi_radio;
  static constexpr Respuesta answer = Respuesta::radio_no_positivo;
};

inline constexpr clause Radio_No_Positivo_pre_1{"Radio_No_Positivo.pre.1", "radio? ∉ Rmas"};
inline constexpr clause Radio_No_Positivo_post_1{"Radio_No_Positivo.post.1", "r! = radio_no_positivo"};

/// What the text says of it.
template <class Visit>
void clauses(const Radio_No_Positivo& in, const Escena&, Respuesta r, Visit&& visit) {
  visit(Radio_No_Positivo_pre_1, [&] { return !Rmas::contains(in.radio); });
  visit(Radio_No_Positivo_post_1, [&] { return r == Respuesta::radio_no_positivo; });
}

struct Vector_No_Unitario {
  Vector vector;
  static constexpr auto component = &Escena::mi_vector;
  static constexpr Respuesta answer = Respuesta::vector_no_unitario;
};

inline constexpr clause Vector_No_Unitario_pre_1{"Vector_No_Unitario.pre.1", "vector? ∉ Unitario"};
inline constexpr clause Vector_No_Unitario_post_1{"Vector_No_Unitario.post.1", "r! = vector_no_unitario"};

/// What the text says of it.
template <class Visit>
void clauses(const Vector_No_Unitario& in, const Escena&, Respuesta r, Visit&& visit) {
  visit(Vector_No_Unitario_pre_1, [&] { return !Unitario::contains(in.vector); });
  visit(Vector_No_Unitario_post_1, [&] { return r == Respuesta::vector_no_unitario; });
}

struct Altura_No_Positiva {
  double altura;
  static constexpr auto component = &Escena::mi_altura;
  static constexpr Respuesta answer = Respuesta::altura_no_positiva;
};

inline constexpr clause Altura_No_Positiva_pre_1{"Altura_No_Positiva.pre.1", "altura? ∉ Rmas"};
inline constexpr clause Altura_No_Positiva_post_1{"Altura_No_Positiva.post.1", "r! = altura_no_positiva"};

/// What the text says of it.
template <class Visit>
void clauses(const Altura_No_Positiva& in, const Escena&, Respuesta r, Visit&& visit) {
  visit(Altura_No_Positiva_pre_1, [&] { return !Rmas::contains(in.altura); });
  visit(Altura_No_Positiva_post_1, [&] { return r == Respuesta::altura_no_positiva; });
}

struct Proporcion_No_Positiva {
  double proporcion;
  static constexpr auto component = &Escena::mi_proporcion;
  static constexpr Respuesta answer = Respuesta::proporcion_no_positiva;
};

inline constexpr clause Proporcion_No_Positiva_pre_1{"Proporcion_No_Positiva.pre.1", "proporcion? ∉ Rmas"};
inline constexpr clause Proporcion_No_Positiva_post_1{"Proporcion_No_Positiva.post.1", "r! = proporcion_no_positiva"};

/// What the text says of it.
template <class Visit>
void clauses(const Proporcion_No_Positiva& in, const Escena&, Respuesta r, Visit&& visit) {
  visit(Proporcion_No_Positiva_pre_1, [&] { return !Rmas::contains(in.proporcion); });
  visit(Proporcion_No_Positiva_post_1, [&] { return r == Respuesta::proporcion_no_positiva; });
}

struct Vertices_Alineados {
  Terna vertices;
  static constexpr auto component = &Escena::mi_vertices;
  static constexpr Respuesta answer = Respuesta::vertices_alineados;
};

inline constexpr clause Vertices_Alineados_pre_1{"Vertices_Alineados.pre.1", "vertices? ∉ Vertices"};
inline constexpr clause Vertices_Alineados_post_1{"Vertices_Alineados.post.1", "r! = vertices_alineados"};

/// What the text says of it.
template <class Visit>
void clauses(const Vertices_Alineados& in, const Escena&, Respuesta r, Visit&& visit) {
  visit(Vertices_Alineados_pre_1, [&] { return !Vertices::contains(in.vertices); });
  visit(Vertices_Alineados_post_1, [&] { return r == Respuesta::vertices_alineados; });
}

}  // namespace durero::model
