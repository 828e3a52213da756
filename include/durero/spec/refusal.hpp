#pragma once
/// The message about an evaluation that does not come to an end, the same for whoever asks.

#include <string>

#include "durero/zed/value/value.hpp"

namespace durero::spec {

/// A message about a term that is not decided.
struct EvaluationRefusal {
  std::string wrong;     ///< what is wrong
  std::string expected;  ///< what would help
};

/// The message about an error of the evaluation, by its kind: a constant without a value, a text that no values
/// satisfy, a set with too many members, or what no equation gives.
EvaluationRefusal refusal_of(const zed::EvaluationError& error);

}  // namespace durero::spec
