#include "durero/model/operaciones_clauses.hpp"

namespace durero::model {

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
