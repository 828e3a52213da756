#include "durero/model/historia.hpp"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

#include "durero/model/malla_clauses.hpp"
#include "durero/model/type_list.hpp"

namespace durero::model {
namespace {

using contract::cost;

// Inverses: the operations that undo others.

/// @{ A value of a component, as an operation takes it.
double as_input(const Rmas& x) { return x.value(); }
const Punto& as_input(const Punto& x) { return x; }
const Vector& as_input(const Vector& x) { return x; }
const Terna& as_input(const Vertices& x) { return x.terna(); }
/// @}

/// The addition of an element as it is in a scene.
ElementOperation addition_of(const Escena& s, const Elemento& e) {
  Agregar_Elemento all{e, s.de_que_tipo.at(e)};
  for_each_attribute([&](const auto& attribute) {
    const auto maplet = (s.*attribute.component).find(e);
    if (maplet != (s.*attribute.component).end()) attribute.input(all) = as_input(maplet->second);
  });
  return Operation(std::visit([](auto&& in) { return Operation(std::move(in)); }, specific(all)));
}

/// The change of an attribute to the value that the element has in a scene.
template <class Change>
ElementOperation change_to(const Escena& s, const Elemento& e) {
  return AttributeChange(Change{e, as_input((s.*Change::component).at(e))});
}

ElementOperation inverse_of(const Escena& s, const AttributeChange& change) {
  return std::visit([&]<class Change>(const Change& in) { return change_to<Change>(s, in.e); }, change);
}
ElementOperation inverse_of(const Escena& s, const Operation& operation) {
  const auto inverse_of_one = [&](const auto& in) {
    if constexpr (requires { in.t; })
      return ElementOperation(Operation(Eliminar_Elemento{in.e}));
    else
      return addition_of(s, in.e);
  };
  return std::visit(inverse_of_one, operation);
}

MeshOperation inverse_of(const Mallas&, const Agregar_Malla& in) { return Eliminar_Malla{in.m}; }
MeshOperation inverse_of(const Mallas& s, const Eliminar_Malla& in) {
  return Agregar_Malla{in.m, s.mallas.at(in.m).red()};
}
MeshOperation inverse_of(const Mallas& s, const Reemplazar_Malla& in) {
  return Reemplazar_Malla{in.m, s.mallas.at(in.m).red()};
}
MeshOperation inverse_of(const Mallas& s, const Mover_Vertice& in) {
  return Mover_Vertice{in.m, in.n, s.mallas.at(in.m).red().puntos().at(in.n)};
}

/// The change of this attribute that may lead from one scene to another: of the first element that has two values, or
/// of any, where none has; nothing where no element has the attribute, or not the same elements have it.
template <class Change>
std::optional<ElementOperation> change_between(const Escena& from, const Escena& to) {
  const auto &a = from.*Change::component, &b = to.*Change::component;
  if (a.empty() || a.size() != b.size()) return std::nullopt;
  const auto at = std::mismatch(a.begin(), a.end(), b.begin()).second;
  return change_to<Change>(to, (at == b.end() ? b.begin() : at)->first);
}

/// visit(std::type_identity<Change>) for the change of each attribute.
template <class Visit>
void for_each_change(Visit&& visit) {
  [&]<class... Change>(std::type_identity<std::variant<Change...>>) {
    (visit(std::type_identity<Change>()), ...);
  }(std::type_identity<AttributeChange>());
}

bool leads(const Escena& from, const ElementOperation& operation, const Escena& to) {
  Escena reached = from;
  return apply_either(reached, operation).ok() && reached == to;
}

// Histories

/// pliegue(ops?), as one step.
Operacion joined(const std::vector<Operacion>& ops) {
  Operacion all;
  for (const Operacion& op : ops) all.insert(all.end(), op.begin(), op.end());
  return all;
}

/// What is left of a history's steps by an operation.
struct StepsAfter {
  std::vector<Operacion> hechas, deshechas;
};

StepsAfter steps_after(const Historia& s, const Transaccion& in) {
  StepsAfter after{s.hechas, {}};
  after.hechas.push_back(joined(in.ops));
  return after;
}
StepsAfter steps_after(const Historia& s, const Deshacer&) {
  StepsAfter after{s.hechas, s.deshechas};
  after.deshechas.insert(after.deshechas.begin(), after.hechas.back());
  after.hechas.pop_back();
  return after;
}
StepsAfter steps_after(const Historia& s, const Rehacer&) {
  StepsAfter after{s.hechas, s.deshechas};
  after.hechas.push_back(after.deshechas.front());
  after.deshechas.erase(after.deshechas.begin());
  return after;
}

bool can_happen(const Historia& s, const Transaccion& in) { return pliegue(in.ops, s.escena).has_value(); }
bool can_happen(const Historia& s, const Deshacer&) { return !s.hechas.empty(); }
bool can_happen(const Historia& s, const Rehacer&) { return !s.deshechas.empty(); }

Historia after_of(const Historia& s, const HistoryOperation& operation) {
  StepsAfter steps = std::visit([&](const auto& in) { return steps_after(s, in); }, operation);
  return {pliegue(steps.hechas, s.inicial).value(), s.inicial, std::move(steps.hechas), std::move(steps.deshechas)};
}

/// Whether as many steps make the same scenes of one, each after those before it.
bool same_steps(const std::vector<Operacion>& a, const std::vector<Operacion>& b, const Escena& escena) {
  if (a.size() != b.size()) return false;
  std::optional<Escena> of_a = escena, of_b = escena;
  for (std::size_t i = 0; i < a.size() && of_a && of_b; ++i) {
    of_a = pliegue({a[i]}, *of_a);
    of_b = pliegue({b[i]}, *of_b);
    if (of_a != of_b) return false;
  }
  return of_a.has_value() && of_b.has_value();
}

/// The labels of an operation on histories, and of its error.
struct HistoryClauses {
  const clause *pre, *done, *undone, *answers;
  const clause *denial_pre, *denial_post;
  Respuesta denial;
};
HistoryClauses clauses_of(const Transaccion&) {
  return {&Transaccion_pre_1,
          &Transaccion_post_1,
          &Transaccion_post_2,
          &Transaccion_post_3,
          &Transaccion_Rechazada_pre_1,
          &Transaccion_Rechazada_post_1,
          Respuesta::transaccion_rechazada};
}
HistoryClauses clauses_of(const Deshacer&) {
  return {&Deshacer_pre_1,
          &Deshacer_post_1,
          &Deshacer_post_2,
          &Deshacer_post_3,
          &Nada_Que_Deshacer_pre_1,
          &Nada_Que_Deshacer_post_1,
          Respuesta::nada_que_deshacer};
}
HistoryClauses clauses_of(const Rehacer&) {
  return {&Rehacer_pre_1,
          &Rehacer_post_1,
          &Rehacer_post_2,
          &Rehacer_post_3,
          &Nada_Que_Rehacer_pre_1,
          &Nada_Que_Rehacer_post_1,
          Respuesta::nada_que_rehacer};
}

}  // namespace

Answer apply_total(Mallas& s, const AttributeChange& change) {
  const Elemento& e = name_of(change);
  if (de_malla(s).contains(e)) {
    const Es_De_Malla error{e};
    if (contract::evaluated(cost::normal)) check(judgements(s, error, error.answer), cost::normal);
    return {error.answer, &Fuera_De_Malla_pre_1};
  }
  Mallas after = s;
  const Answer answer = apply_total(after.escena, change);
  if (contract::evaluated(cost::normal)) {
    check({{&Mismas_Mallas_post_1, after.mallas == s.mallas}}, cost::normal);
    check(inv(after), cost::normal);
  }
  s = std::move(after);
  return answer;
}

ElementOperation inverse(const Escena& before, const ElementOperation& operation) {
  return std::visit([&](const auto& in) { return inverse_of(before, in); }, operation);
}

MeshOperation inverse(const Mallas& before, const MeshOperation& operation) {
  return std::visit([&](const auto& in) { return inverse_of(before, in); }, operation);
}

std::optional<ElementOperation> transition(const Escena& from, const Escena& to) {
  const auto absent = [](const Escena& escena) {
    return [&](const Elemento& e) { return !escena.elementos.contains(e); };
  };
  std::optional<ElementOperation> found;
  const auto consider = [&](const std::optional<ElementOperation>& operation) {
    if (!found && operation && leads(from, *operation, to)) found = operation;
  };
  if (const auto e = std::ranges::find_if(to.elementos, absent(from)); e != to.elementos.end())
    consider(addition_of(to, *e));
  if (const auto e = std::ranges::find_if(from.elementos, absent(to)); e != from.elementos.end())
    consider(Operation(Eliminar_Elemento{*e}));
  for_each_change([&]<class Change>(std::type_identity<Change>) { consider(change_between<Change>(from, to)); });
  return found;
}

std::optional<Escena> pliegue(const std::vector<Operacion>& ops, Escena escena) {
  for (const Operacion& op : ops)
    for (const ElementOperation& operation : op)
      if (!apply_either(escena, operation).ok()) return std::nullopt;
  return escena;
}

Judgements inv(const Historia& s) {
  Judgements all = inv(s.escena);
  all.push_back({&Historia_inv_1, pliegue(s.hechas, s.inicial) == s.escena});
  all.push_back({&Historia_inv_2, pliegue(s.deshechas, s.escena).has_value()});
  return all;
}

Judgements Init_Historia_post(const Historia& after) {
  return {{&Init_Historia_post_1, after.inicial == after.escena},
          {&Init_Historia_post_2, after.hechas.empty()},
          {&Init_Historia_post_3, after.deshechas.empty()}};
}

Historia Init_Historia(const Escena& escena) {
  Historia after{escena, escena, {}, {}};
  if (contract::evaluated(cost::normal)) {
    check(Init_Historia_post(after), cost::normal);
    check(inv(after), cost::normal);
  }
  return after;
}

Judgements pre(const Historia& before, const HistoryOperation& operation) {
  return std::visit(
      [&](const auto& in) {
        return Judgements{{clauses_of(in).pre, can_happen(before, in)}};
      },
      operation);
}

Judgements post(const Historia& before, const HistoryOperation& operation, const Historia& after, Respuesta r) {
  const auto judged = [&](const auto& in) -> Judgements {
    const HistoryClauses labels = clauses_of(in);
    const StepsAfter steps = steps_after(before, in);
    return {{&Seguir_post_1, after.inicial == before.inicial},
            {&Seguir_post_2, after.escena == pliegue(after.hechas, after.inicial)},
            {labels.done, same_steps(after.hechas, steps.hechas, before.inicial)},
            {labels.undone, same_steps(after.deshechas, steps.deshechas, after.escena)},
            {labels.answers, r == in.answer}};
  };
  return std::visit(judged, operation);
}

Respuesta apply(Historia& s, const HistoryOperation& operation) {
  if (contract::evaluated(cost::normal)) check(pre(s, operation), cost::normal);
  const Respuesta r = std::visit([](const auto& in) { return in.answer; }, operation);
  Historia after = after_of(s, operation);
  if (contract::evaluated(cost::normal)) {
    check(post(s, operation, after, r), cost::normal);
    check(inv(after), cost::normal);
  }
  s = std::move(after);
  return r;
}

Answer apply_total(Historia& s, const HistoryOperation& operation) {
  const auto refused = [&](const auto& in) -> std::optional<Answer> {
    if (can_happen(s, in)) return std::nullopt;
    const HistoryClauses labels = clauses_of(in);
    if (contract::evaluated(cost::normal))
      check({{labels.denial_pre, !can_happen(s, in)}, {labels.denial_post, true}}, cost::normal);
    return Answer{labels.denial, labels.pre};
  };
  const auto answer = std::visit(refused, operation);
  return answer ? *answer : Answer{apply(s, operation)};
}

}  // namespace durero::model
