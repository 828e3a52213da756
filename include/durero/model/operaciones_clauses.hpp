#pragma once
/// What spec/operaciones.tex says of each operation and of each error, evaluated over the states of the model. What it
/// says of one type stands in model/tipo/, as tables; what it says of all stands here.
///
/// preconditions(in, before, visit) hands each precondition to `visit(clause, refusal, holds)`: the partial operation
/// checks it as a contract, the total one answers the refusal of the first that does not hold.
/// postconditions(in, delta, r, visit) hands each postcondition to `visit(clause, holds)`.

#include <optional>

#include "durero/model/delta.hpp"
#include "durero/model/operaciones.hpp"
#include "durero/model/operaciones_errors.hpp"

namespace durero::model {

// The errors.

/// The errors of the types of a list.
template <class List>
struct Errors;
/// The only list that there is: a tuple.
template <class... Type>
struct Errors<std::tuple<Type...>> {
  /// Any error: those of every type, then those of one.
  using Any =
      std::variant<Elemento_Ya_Existe, Elemento_No_Existe, Radio_No_Positivo, Vector_No_Unitario, Altura_No_Positiva,
                   Proporcion_No_Positiva, Vertices_Alineados, typename Type::Removal::Denial...>;
};
/// Any error.
using Error = Errors<Types>::Any;

/// No_Es_…, of every type.
template <class Denial, class Visit>
  requires requires { Denial::is_of_another_type; }
void clauses(const Denial& in, const Escena& s, Respuesta r, Visit&& visit) {
  visit(*Denial::exists, [&] { return s.elementos.contains(in.e); });
  visit(*Denial::is_of_another_type, [&] { return !is_of_type(s, in.e, Denial::tipo); });
  visit(*Denial::answers, [&] { return r == Respuesta::tipo_incorrecto; });
}

/// The clauses of an error that answers r, judged.
Judgements judgements(const Escena& escena, const Error& error, Respuesta r);

/// The error, as an operation that changes nothing: checks its clauses and answers.
Respuesta apply(const Escena& escena, const Error& error);

/// The error by which a total operation denies a precondition; none where it hides what the precondition speaks of.
using Refusal = std::optional<Error>;
/// The refusal of a precondition that the total operation hides.
inline constexpr std::nullopt_t hidden = std::nullopt;

/// The refusals at which Agregar_Elemento_Total looks: those of the attributes that the type t? has.
Refusal refusal_for(const Refusal& refusal, Tipo t);

// The additions. Every one includes Agregar_Elemento.

inline constexpr clause Agregar_Elemento_pre_1{"Agregar_Elemento.pre.1", "e? ∉ elementos"};
inline constexpr clause Agregar_Elemento_post_1{"Agregar_Elemento.post.1", "elementos' = elementos ∪ { e? }"};
inline constexpr clause Agregar_Elemento_post_2{"Agregar_Elemento.post.2", "de_que_tipo' = de_que_tipo ∪ { e? ↦ t? }"};

/// The addition of one type.
template <class Op>
concept AdditionOfType = requires { Op::requirements; };

/// Of the addition of one type.
template <AdditionOfType Op, class Visit>
void preconditions(const Op& in, const Escena& s, Visit&& visit) {
  visit(Agregar_Elemento_pre_1, Elemento_Ya_Existe{in.e}, [&] { return !s.elementos.contains(in.e); });
  visit(*Op::is_of_type, hidden, [&] { return in.t == Op::tipo; });
  for_each_entry(Op::requirements, [&]<class Entry>(const Entry& required) {
    visit(*required.what, typename Entry::Denial{required.input(in)}, [&] { return required.holds(in); });
  });
}

/// @{ Whether that became of the component, by the states of the model.
template <auto component, auto input>
bool has_effect(const Joined<component, input>&, const auto& in, const Delta& d) {
  return d.with(component, in.*input);
}
template <auto component, auto input>
bool has_effect(const Replaced<component, input>&, const auto& in, const Delta& d) {
  return d.replaced(component, in.*input);
}
template <auto component>
bool has_effect(const Kept<component>&, const auto&, const Delta& d) {
  return d.same(component);
}
template <auto component>
bool has_effect(const Dropped<component>&, const auto&, const Delta& d) {
  return d.without(component);
}
/// @}

/// The part of both additions and removals that stands in model/tipo/, over states of which has_effect(effect, in,
/// done) is declared where their type is: Delta, or what the compact scene knows of an edit.
template <class Op, class Done, class Visit>
void postconditions_of_type(const Op& in, const Done& done, Respuesta r, Visit&& visit) {
  for_each_entry(Op::effects,
                 [&](const auto& effect) { visit(*effect.what, [&] { return has_effect(effect, in, done); }); });
  visit(*Op::answers, [&] { return r == Op::answer; });
}

/// Of the addition of one type.
template <AdditionOfType Op, class Visit>
void postconditions(const Op& in, const Delta& d, Respuesta r, Visit&& visit) {
  visit(Agregar_Elemento_post_1, [&] { return d.added(); });
  visit(Agregar_Elemento_post_2, [&] { return d.with(&Escena::de_que_tipo, in.t); });
  postconditions_of_type(in, d, r, visit);
}

// The removals. Every one includes Eliminar_Elemento.

inline constexpr clause Eliminar_Elemento_pre_1{"Eliminar_Elemento.pre.1", "e? ∈ elementos"};
inline constexpr clause Eliminar_Elemento_post_1{"Eliminar_Elemento.post.1", "elementos' = elementos ∖ { e? }"};
inline constexpr clause Eliminar_Elemento_post_2{"Eliminar_Elemento.post.2", "de_que_tipo' = { e? } ⩤ de_que_tipo"};

/// The removal of one type.
template <class Op>
concept RemovalOfType = requires { typename Op::Denial; };

/// Of every removal.
template <class Visit>
void preconditions_of_removal(const auto& in, const Escena& s, Visit&& visit) {
  visit(Eliminar_Elemento_pre_1, Elemento_No_Existe{in.e}, [&] { return s.elementos.contains(in.e); });
}

/// Of the removal of one type.
template <RemovalOfType Op, class Visit>
void preconditions(const Op& in, const Escena& s, Visit&& visit) {
  preconditions_of_removal(in, s, visit);
  visit(*Op::is_of_type, typename Op::Denial{in.e}, [&] { return is_of_type(s, in.e, Op::tipo); });
}

/// Of the removal of one type.
template <RemovalOfType Op, class Visit>
void postconditions(const Op& in, const Delta& d, Respuesta r, Visit&& visit) {
  visit(Eliminar_Elemento_post_1, [&] { return d.removed(); });
  visit(Eliminar_Elemento_post_2, [&] { return d.without(&Escena::de_que_tipo); });
  postconditions_of_type(in, d, r, visit);
}

// Elemento_Agregado: (Agregar_Esfera ∨ Agregar_Cilindro ∨ …) \ (r!) ∧ [ r! = elemento_agregado ]

inline constexpr clause Elemento_Agregado_post_1{"Elemento_Agregado.post.1", "r! = elemento_agregado"};

/// Of the general addition: those of the type t?, whose error it answers where t? has the attribute.
template <class Visit>
void preconditions(const Agregar_Elemento& in, const Escena& s, Visit&& visit) {
  const auto visit_of_type = [&](const clause& what, const Refusal& refusal, auto&& holds) {
    visit(what, refusal_for(refusal, in.t), holds);
  };
  std::visit([&](const auto& addition) { preconditions(addition, s, visit_of_type); }, specific(in));
}

/// Of the general addition: those of the type t?, with the general answer.
template <class Visit>
void postconditions(const Agregar_Elemento& in, const Delta& d, Respuesta r, Visit&& visit) {
  // Where r! is hidden some answer of the specific addition must do, and its own is the one that does.
  std::visit([&](const auto& addition) { postconditions(addition, d, addition.answer, visit); }, specific(in));
  visit(Elemento_Agregado_post_1, [&] { return r == Respuesta::elemento_agregado; });
}

// Elemento_Eliminado: (Eliminar_Esfera ∨ Eliminar_Cilindro ∨ …) \ (r!) ∧ [ r! = elemento_eliminado ]

inline constexpr clause Elemento_Eliminado_post_1{"Elemento_Eliminado.post.1", "r! = elemento_eliminado"};

/// Where e? ∈ elementos, one of the types is its own.
template <class Visit>
void preconditions(const Eliminar_Elemento& in, const Escena& s, Visit&& visit) {
  preconditions_of_removal(in, s, visit);
}

/// Of the general removal: those of the type of the element, with the general answer.
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
