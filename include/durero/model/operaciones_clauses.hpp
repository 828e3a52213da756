#pragma once
/// What spec/operaciones.tex says of each operation: a block for each schema, in the order of the text.
///
/// preconditions(in, before, visit) hands each precondition to `visit(clause, refusal, holds)`: the partial operation
/// checks it as a contract, the total one answers the refusal of the first that does not hold.
/// postconditions(in, delta, r, visit) hands each postcondition to `visit(clause, holds)`.

#include "durero/model/delta.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/model/operaciones_errors.hpp"

namespace durero::model {

// Agregar_Elemento: every addition includes it.

inline constexpr clause Agregar_Elemento_pre_1{"Agregar_Elemento.pre.1", "e? ∉ elementos"};
inline constexpr clause Agregar_Elemento_post_1{"Agregar_Elemento.post.1", "elementos' = elementos ∪ { e? }"};
inline constexpr clause Agregar_Elemento_post_2{"Agregar_Elemento.post.2", "de_que_tipo' = de_que_tipo ∪ { e? ↦ t? }"};

template <class Visit>
void preconditions_of_addition(const auto& in, const Escena& s, Visit&& visit) {
  visit(Agregar_Elemento_pre_1, Elemento_Ya_Existe{in.e}, [&] { return !s.elementos.contains(in.e); });
}

template <class Visit>
void postconditions_of_addition(const auto& in, const Delta& d, Visit&& visit) {
  visit(Agregar_Elemento_post_1, [&] { return d.added(); });
  visit(Agregar_Elemento_post_2, [&] { return d.with(&Escena::de_que_tipo, in.t); });
}

// Eliminar_Elemento: every removal includes it.

inline constexpr clause Eliminar_Elemento_pre_1{"Eliminar_Elemento.pre.1", "e? ∈ elementos"};
inline constexpr clause Eliminar_Elemento_post_1{"Eliminar_Elemento.post.1", "elementos' = elementos ∖ { e? }"};
inline constexpr clause Eliminar_Elemento_post_2{"Eliminar_Elemento.post.2", "de_que_tipo' = { e? } ⩤ de_que_tipo"};

template <class Visit>
void preconditions_of_removal(const auto& in, const Escena& s, Visit&& visit) {
  visit(Eliminar_Elemento_pre_1, Elemento_No_Existe{in.e}, [&] { return s.elementos.contains(in.e); });
}

template <class Visit>
void postconditions_of_removal(const Delta& d, Visit&& visit) {
  visit(Eliminar_Elemento_post_1, [&] { return d.removed(); });
  visit(Eliminar_Elemento_post_2, [&] { return d.without(&Escena::de_que_tipo); });
}

// Agregar_Esfera

inline constexpr clause Agregar_Esfera_pre_1{"Agregar_Esfera.pre.1", "t? = soy_esfera"};
inline constexpr clause Agregar_Esfera_pre_2{"Agregar_Esfera.pre.2", "radio? ∈ Rmas"};
inline constexpr clause Agregar_Esfera_post_1{"Agregar_Esfera.post.1", "mi_centro' = mi_centro ∪ { e? ↦ centro? }"};
inline constexpr clause Agregar_Esfera_post_2{"Agregar_Esfera.post.2", "mi_radio' = mi_radio ∪ { e? ↦ radio? }"};
inline constexpr clause Agregar_Esfera_post_3{"Agregar_Esfera.post.3", "mi_vector' = mi_vector"};
inline constexpr clause Agregar_Esfera_post_4{"Agregar_Esfera.post.4", "mi_altura' = mi_altura"};
inline constexpr clause Agregar_Esfera_post_5{"Agregar_Esfera.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Agregar_Esfera_post_6{"Agregar_Esfera.post.6", "r! = esfera_agregada"};

template <class Visit>
void preconditions(const Agregar_Esfera& in, const Escena& s, Visit&& visit) {
  preconditions_of_addition(in, s, visit);
  visit(Agregar_Esfera_pre_1, hidden, [&] { return in.t == Tipo::soy_esfera; });
  visit(Agregar_Esfera_pre_2, Radio_No_Positivo{in.radio}, [&] { return Rmas::contains(in.radio); });
}

template <class Visit>
void postconditions(const Agregar_Esfera& in, const Delta& d, Respuesta r, Visit&& visit) {
  postconditions_of_addition(in, d, visit);
  visit(Agregar_Esfera_post_1, [&] { return d.with(&Escena::mi_centro, in.centro); });
  visit(Agregar_Esfera_post_2, [&] { return d.with(&Escena::mi_radio, in.radio); });
  visit(Agregar_Esfera_post_3, [&] { return d.same(&Escena::mi_vector); });
  visit(Agregar_Esfera_post_4, [&] { return d.same(&Escena::mi_altura); });
  visit(Agregar_Esfera_post_5, [&] { return d.same(&Escena::mi_proporcion); });
  visit(Agregar_Esfera_post_6, [&] { return r == Respuesta::esfera_agregada; });
}

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
inline constexpr clause Agregar_Cilindro_post_6{"Agregar_Cilindro.post.6", "r! = cilindro_agregado"};

template <class Visit>
void preconditions(const Agregar_Cilindro& in, const Escena& s, Visit&& visit) {
  preconditions_of_addition(in, s, visit);
  visit(Agregar_Cilindro_pre_1, hidden, [&] { return in.t == Tipo::soy_cilindro; });
  visit(Agregar_Cilindro_pre_2, Radio_No_Positivo{in.radio}, [&] { return Rmas::contains(in.radio); });
  visit(Agregar_Cilindro_pre_3, Vector_No_Unitario{in.vector}, [&] { return Unitario::contains(in.vector); });
  visit(Agregar_Cilindro_pre_4, Altura_No_Positiva{in.altura}, [&] { return Rmas::contains(in.altura); });
}

template <class Visit>
void postconditions(const Agregar_Cilindro& in, const Delta& d, Respuesta r, Visit&& visit) {
  postconditions_of_addition(in, d, visit);
  visit(Agregar_Cilindro_post_1, [&] { return d.with(&Escena::mi_centro, in.centro); });
  visit(Agregar_Cilindro_post_2, [&] { return d.with(&Escena::mi_radio, in.radio); });
  visit(Agregar_Cilindro_post_3, [&] { return d.with(&Escena::mi_vector, in.vector); });
  visit(Agregar_Cilindro_post_4, [&] { return d.with(&Escena::mi_altura, in.altura); });
  visit(Agregar_Cilindro_post_5, [&] { return d.same(&Escena::mi_proporcion); });
  visit(Agregar_Cilindro_post_6, [&] { return r == Respuesta::cilindro_agregado; });
}

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
inline constexpr clause Agregar_Cono_post_6{"Agregar_Cono.post.6", "r! = cono_agregado"};

template <class Visit>
void preconditions(const Agregar_Cono& in, const Escena& s, Visit&& visit) {
  preconditions_of_addition(in, s, visit);
  visit(Agregar_Cono_pre_1, hidden, [&] { return in.t == Tipo::soy_cono; });
  visit(Agregar_Cono_pre_2, Proporcion_No_Positiva{in.proporcion}, [&] { return Rmas::contains(in.proporcion); });
  visit(Agregar_Cono_pre_3, Vector_No_Unitario{in.vector}, [&] { return Unitario::contains(in.vector); });
  visit(Agregar_Cono_pre_4, Altura_No_Positiva{in.altura}, [&] { return Rmas::contains(in.altura); });
}

template <class Visit>
void postconditions(const Agregar_Cono& in, const Delta& d, Respuesta r, Visit&& visit) {
  postconditions_of_addition(in, d, visit);
  visit(Agregar_Cono_post_1, [&] { return d.with(&Escena::mi_centro, in.centro); });
  visit(Agregar_Cono_post_2, [&] { return d.same(&Escena::mi_radio); });
  visit(Agregar_Cono_post_3, [&] { return d.with(&Escena::mi_vector, in.vector); });
  visit(Agregar_Cono_post_4, [&] { return d.with(&Escena::mi_altura, in.altura); });
  visit(Agregar_Cono_post_5, [&] { return d.with(&Escena::mi_proporcion, in.proporcion); });
  visit(Agregar_Cono_post_6, [&] { return r == Respuesta::cono_agregado; });
}

// Eliminar_Esfera

inline constexpr clause Eliminar_Esfera_pre_1{"Eliminar_Esfera.pre.1", "de_que_tipo(e?) = soy_esfera"};
inline constexpr clause Eliminar_Esfera_post_1{"Eliminar_Esfera.post.1", "mi_centro' = { e? } ⩤ mi_centro"};
inline constexpr clause Eliminar_Esfera_post_2{"Eliminar_Esfera.post.2", "mi_radio' = { e? } ⩤ mi_radio"};
inline constexpr clause Eliminar_Esfera_post_3{"Eliminar_Esfera.post.3", "mi_vector' = mi_vector"};
inline constexpr clause Eliminar_Esfera_post_4{"Eliminar_Esfera.post.4", "mi_altura' = mi_altura"};
inline constexpr clause Eliminar_Esfera_post_5{"Eliminar_Esfera.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Eliminar_Esfera_post_6{"Eliminar_Esfera.post.6", "r! = esfera_eliminada"};

template <class Visit>
void preconditions(const Eliminar_Esfera& in, const Escena& s, Visit&& visit) {
  preconditions_of_removal(in, s, visit);
  visit(Eliminar_Esfera_pre_1, No_Es_Esfera{in.e}, [&] { return is_of_type(s, in.e, Tipo::soy_esfera); });
}

template <class Visit>
void postconditions(const Eliminar_Esfera&, const Delta& d, Respuesta r, Visit&& visit) {
  postconditions_of_removal(d, visit);
  visit(Eliminar_Esfera_post_1, [&] { return d.without(&Escena::mi_centro); });
  visit(Eliminar_Esfera_post_2, [&] { return d.without(&Escena::mi_radio); });
  visit(Eliminar_Esfera_post_3, [&] { return d.same(&Escena::mi_vector); });
  visit(Eliminar_Esfera_post_4, [&] { return d.same(&Escena::mi_altura); });
  visit(Eliminar_Esfera_post_5, [&] { return d.same(&Escena::mi_proporcion); });
  visit(Eliminar_Esfera_post_6, [&] { return r == Respuesta::esfera_eliminada; });
}

// Eliminar_Cilindro

inline constexpr clause Eliminar_Cilindro_pre_1{"Eliminar_Cilindro.pre.1", "de_que_tipo(e?) = soy_cilindro"};
inline constexpr clause Eliminar_Cilindro_post_1{"Eliminar_Cilindro.post.1", "mi_centro' = { e? } ⩤ mi_centro"};
inline constexpr clause Eliminar_Cilindro_post_2{"Eliminar_Cilindro.post.2", "mi_radio' = { e? } ⩤ mi_radio"};
inline constexpr clause Eliminar_Cilindro_post_3{"Eliminar_Cilindro.post.3", "mi_vector' = { e? } ⩤ mi_vector"};
inline constexpr clause Eliminar_Cilindro_post_4{"Eliminar_Cilindro.post.4", "mi_altura' = { e? } ⩤ mi_altura"};
inline constexpr clause Eliminar_Cilindro_post_5{"Eliminar_Cilindro.post.5", "mi_proporcion' = mi_proporcion"};
inline constexpr clause Eliminar_Cilindro_post_6{"Eliminar_Cilindro.post.6", "r! = cilindro_eliminado"};

template <class Visit>
void preconditions(const Eliminar_Cilindro& in, const Escena& s, Visit&& visit) {
  preconditions_of_removal(in, s, visit);
  visit(Eliminar_Cilindro_pre_1, No_Es_Cilindro{in.e}, [&] { return is_of_type(s, in.e, Tipo::soy_cilindro); });
}

template <class Visit>
void postconditions(const Eliminar_Cilindro&, const Delta& d, Respuesta r, Visit&& visit) {
  postconditions_of_removal(d, visit);
  visit(Eliminar_Cilindro_post_1, [&] { return d.without(&Escena::mi_centro); });
  visit(Eliminar_Cilindro_post_2, [&] { return d.without(&Escena::mi_radio); });
  visit(Eliminar_Cilindro_post_3, [&] { return d.without(&Escena::mi_vector); });
  visit(Eliminar_Cilindro_post_4, [&] { return d.without(&Escena::mi_altura); });
  visit(Eliminar_Cilindro_post_5, [&] { return d.same(&Escena::mi_proporcion); });
  visit(Eliminar_Cilindro_post_6, [&] { return r == Respuesta::cilindro_eliminado; });
}

// Eliminar_Cono

inline constexpr clause Eliminar_Cono_pre_1{"Eliminar_Cono.pre.1", "de_que_tipo(e?) = soy_cono"};
inline constexpr clause Eliminar_Cono_post_1{"Eliminar_Cono.post.1", "mi_centro' = { e? } ⩤ mi_centro"};
inline constexpr clause Eliminar_Cono_post_2{"Eliminar_Cono.post.2", "mi_radio' = mi_radio"};
inline constexpr clause Eliminar_Cono_post_3{"Eliminar_Cono.post.3", "mi_vector' = { e? } ⩤ mi_vector"};
inline constexpr clause Eliminar_Cono_post_4{"Eliminar_Cono.post.4", "mi_altura' = { e? } ⩤ mi_altura"};
inline constexpr clause Eliminar_Cono_post_5{"Eliminar_Cono.post.5", "mi_proporcion' = { e? } ⩤ mi_proporcion"};
inline constexpr clause Eliminar_Cono_post_6{"Eliminar_Cono.post.6", "r! = cono_eliminado"};

template <class Visit>
void preconditions(const Eliminar_Cono& in, const Escena& s, Visit&& visit) {
  preconditions_of_removal(in, s, visit);
  visit(Eliminar_Cono_pre_1, No_Es_Cono{in.e}, [&] { return is_of_type(s, in.e, Tipo::soy_cono); });
}

template <class Visit>
void postconditions(const Eliminar_Cono&, const Delta& d, Respuesta r, Visit&& visit) {
  postconditions_of_removal(d, visit);
  visit(Eliminar_Cono_post_1, [&] { return d.without(&Escena::mi_centro); });
  visit(Eliminar_Cono_post_2, [&] { return d.same(&Escena::mi_radio); });
  visit(Eliminar_Cono_post_3, [&] { return d.without(&Escena::mi_vector); });
  visit(Eliminar_Cono_post_4, [&] { return d.without(&Escena::mi_altura); });
  visit(Eliminar_Cono_post_5, [&] { return d.without(&Escena::mi_proporcion); });
  visit(Eliminar_Cono_post_6, [&] { return r == Respuesta::cono_eliminado; });
}

// Elemento_Agregado: (Agregar_Esfera ∨ Agregar_Cilindro ∨ Agregar_Cono) \ (r!) ∧ [ r! = elemento_agregado ]

inline constexpr clause Elemento_Agregado_post_1{"Elemento_Agregado.post.1", "r! = elemento_agregado"};

template <class Visit>
void preconditions(const Agregar_Elemento& in, const Escena& s, Visit&& visit) {
  const auto visit_of_type = [&](const clause& what, const Refusal& refusal, auto&& holds) {
    visit(what, refusal_for(refusal, in.t), holds);
  };
  std::visit([&](const auto& addition) { preconditions(addition, s, visit_of_type); }, specific(in));
}

template <class Visit>
void postconditions(const Agregar_Elemento& in, const Delta& d, Respuesta r, Visit&& visit) {
  // Where r! is hidden some answer of the specific addition must do, and its own is the one that does.
  std::visit([&](const auto& addition) { postconditions(addition, d, addition.answer, visit); }, specific(in));
  visit(Elemento_Agregado_post_1, [&] { return r == Respuesta::elemento_agregado; });
}

// Elemento_Eliminado: (Eliminar_Esfera ∨ Eliminar_Cilindro ∨ Eliminar_Cono) \ (r!) ∧ [ r! = elemento_eliminado ]

inline constexpr clause Elemento_Eliminado_post_1{"Elemento_Eliminado.post.1", "r! = elemento_eliminado"};

/// Where e? ∈ elementos, one of the three types is its own.
template <class Visit>
void preconditions(const Eliminar_Elemento& in, const Escena& s, Visit&& visit) {
  preconditions_of_removal(in, s, visit);
}

template <class Visit>
void postconditions(const Eliminar_Elemento& in, const Delta& d, Respuesta r, Visit&& visit) {
  std::visit([&](const auto& removal) { postconditions(removal, d, removal.answer, visit); }, specific(d.before(), in));
  visit(Elemento_Eliminado_post_1, [&] { return r == Respuesta::elemento_eliminado; });
}

/// The preconditions over the before-state and the inputs, judged. O(log n).
Judgements pre(const Escena& before, const Operation& operation);

/// The postconditions over both states, the inputs and r!, judged: at `audit` price the whole predicates; at `normal`
/// price what changed of them (Delta).
Judgements post(const Escena& before, const Operation& operation, const Escena& after, Respuesta r,
                contract::cost price);

}  // namespace durero::model
