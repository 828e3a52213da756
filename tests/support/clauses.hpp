#pragma once
/// Which label is seen when a clause is broken.

#include <set>
#include <string>
#include <string_view>

#include "durero/model/escena.hpp"

namespace durero::test {

/// The label of the violation that the action throws, or "none".
template <class Action>
std::string violated(Action&& action) {
  try {
    action();
  } catch (const contract::contract_violation& violation) {
    return std::string(violation.label());
  }
  return "none";
}

/// The labels of the judgements that do not hold.
inline std::set<std::string> broken(const model::Judgements& judgements) {
  std::set<std::string> labels;
  for (const model::Judgement& judgement : judgements)
    if (!judgement.holds) labels.emplace(judgement.what->label);
  return labels;
}

}  // namespace durero::test
