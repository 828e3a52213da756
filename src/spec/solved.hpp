#pragma once
/// A predicate is decided by the text, or by the values that a solver finds and the text confirms.

#include <functional>
#include <vector>

#include "durero/spec/refusal.hpp"
#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/smt/smt.hpp"

namespace durero::spec {

/// A text as a predicate sees it.
struct SeenText {
  const std::vector<zed::Section>& sections;
  const zed::Evaluator& evaluator;
  const zed::Valuation& locals;  ///< names that the text does not declare
};

/// Returns the truth of a predicate, which is not open; with what the solver found, where it was asked. `steps` are
/// those of the evaluator, and count from 0 again before the solver is asked; `open` makes the error of a predicate
/// that is open. Throws zed::EvaluationError where it is not decided, and zed::StepsSpent where the evaluation takes
/// more than it may and there is no solver (null).
zed::SmtFinding decided(const zed::Term& predicate, const SeenText& text, zed::Steps& steps,
                        const zed::SmtProgram* solver, const std::function<OpenVariables()>& open);

}  // namespace durero::spec
