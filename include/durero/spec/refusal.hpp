#pragma once
/// The message about an evaluation that does not come to an end, the same for whoever asks.

#include <string>
#include <utility>

#include "durero/zed/value/value.hpp"

namespace durero::spec {

/// A message about a term that is not decided.
struct EvaluationRefusal {
  std::string wrong;     ///< what is wrong
  std::string expected;  ///< what would help
};

/// The error of a term in which a variable has values that cannot be gone through, and no equation gives one.
class OpenVariables : public zed::EvaluationError {
 public:
  /// Takes the question that is not decided, and the expectation that bounds the variables.
  OpenVariables(const std::string& undecided, std::string expected)
      : EvaluationError(undecided), expected_(std::move(expected)) {}
  /// The expectation that bounds them: `expected a bound for x, as x : 0‥9`.
  const std::string& expected() const { return expected_; }

 private:
  std::string expected_;
};

/// The message about an error of the evaluation, by its kind: a constant without a value, a text that no values
/// satisfy, a set with too many members, variables without bounds, or what else it lacks.
EvaluationRefusal refusal_of(const zed::EvaluationError& error);

}  // namespace durero::spec
