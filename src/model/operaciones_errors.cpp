#include "durero/model/operaciones_errors.hpp"

namespace durero::model {
namespace {

/// Agregar_Elemento_Total: Elemento_Ya_Existe ∨ (Radio_No_Positivo ∧ ¬ Es_Cono) ∨ (Proporcion_No_Positiva ∧ Es_Cono) ∨
/// ((Vector_No_Unitario ∨ Altura_No_Positiva) ∧ ¬ Es_Esfera).
struct Agregar_Elemento_Total {
  Tipo t;

  bool operator()(const Elemento_Ya_Existe&) const { return true; }
  bool operator()(const Radio_No_Positivo&) const { return !all_hold(pre(Es_Cono{t})); }
  bool operator()(const Proporcion_No_Positiva&) const { return all_hold(pre(Es_Cono{t})); }
  bool operator()(const Vector_No_Unitario&) const { return !all_hold(pre(Es_Esfera{t})); }
  bool operator()(const Altura_No_Positiva&) const { return !all_hold(pre(Es_Esfera{t})); }
  // The text does not name these errors: an addition has none of them.
  bool operator()(const Elemento_No_Existe&) const { return false; }
  bool operator()(const No_Es_Esfera&) const { return false; }
  bool operator()(const No_Es_Cilindro&) const { return false; }
  bool operator()(const No_Es_Cono&) const { return false; }
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

Judgements pre(const Es_Esfera& in) { return {{&Es_Esfera_pre_1, in.t == Tipo::soy_esfera}}; }

Judgements pre(const Es_Cono& in) { return {{&Es_Cono_pre_1, in.t == Tipo::soy_cono}}; }

Refusal refusal_for(const Refusal& refusal, Tipo t) {
  return refusal && std::visit(Agregar_Elemento_Total{t}, *refusal) ? refusal : hidden;
}

}  // namespace durero::model
