#include "durero/model/operaciones_clauses.hpp"

namespace durero::model {
namespace {

/// Agregar_Elemento_Total: Elemento_Ya_Existe ∨ (Radio_No_Positivo ∧ Con_Radio) ∨ (Proporcion_No_Positiva ∧
/// Con_Proporcion) ∨ (Vector_No_Unitario ∧ Con_Vector) ∨ (Altura_No_Positiva ∧ Con_Altura) ∨ (Vertices_Alineados ∧
/// Con_Vertices).
struct Agregar_Elemento_Total {
  Tipo t;

  bool operator()(const Elemento_Ya_Existe&) const { return true; }
  template <class Denial>
    requires requires { Denial::component; }
  bool operator()(const Denial&) const {
    return all_hold(given<Denial::component>(t));
  }
  // The text does not name these errors: an addition has none of them.
  bool operator()(const Elemento_No_Existe&) const { return false; }
  template <class Denial>
    requires requires { Denial::is_of_another_type; }
  bool operator()(const Denial&) const {
    return false;
  }
};

}  // namespace

Judgements judgements(const Escena& escena, const Error& error, Respuesta r) {
  Judgements all;
  const auto judge = [&](const clause& what, auto&& holds) { all.push_back({&what, holds()}); };
  std::visit([&](const auto& in) { clauses(in, escena, r, judge); }, error);
  return all;
}

Respuesta apply(const Escena& escena, const Error& error) {
  const Respuesta r = std::visit([](const auto& in) { return in.answer; }, error);
  if (contract::evaluated(contract::cost::normal)) check(judgements(escena, error, r), contract::cost::normal);
  return r;
}

Refusal refusal_for(const Refusal& refusal, Tipo t) {
  return refusal && std::visit(Agregar_Elemento_Total{t}, *refusal) ? refusal : hidden;
}

Judgements pre(const Escena& before, const Operation& operation) {
  Judgements all;
  const auto judge = [&](const clause& what, const Refusal&, auto&& holds) { all.push_back({&what, holds()}); };
  std::visit([&](const auto& in) { preconditions(in, before, judge); }, operation);
  return all;
}

Judgements post(const Escena& before, const Operation& operation, const Escena& after, Respuesta r,
                contract::cost price) {
  Judgements all;
  const auto judge = [&](const clause& what, auto&& holds) { all.push_back({&what, holds()}); };
  std::visit([&](const auto& in) { postconditions(in, Delta(before, in.e, after, price), r, judge); }, operation);
  return all;
}

}  // namespace durero::model
