#include "spec/solved.hpp"

#include <fmt/format.h>

namespace durero::spec {
namespace {

/// The truth by the text alone; where it is open, the reason.
struct TruthByText {
  zed::Truth truth = zed::Truth::open;
  std::string why, expected{};
};

TruthByText truth_by_text(const zed::Term& predicate, const SeenText& text, const zed::Steps& steps,
                          const std::function<OpenVariables()>& open) {
  try {
    const zed::Truth truth = text.evaluator.holds(predicate, text.locals);
    if (truth != zed::Truth::open) return {truth, ""};
    const OpenVariables error = open();
    return {truth, error.what(), error.expected()};
  } catch (const zed::Undetermined&) {
    throw;  // no values of variables mend the text
  } catch (const zed::Unsatisfied&) {
    throw;
  } catch (const zed::EvaluationError& error) {
    return {zed::Truth::open, error.what(), refusal_of(error).expected};
  } catch (const zed::StepsSpent&) {
    return {zed::Truth::open, fmt::format("it takes more than {} steps", steps.most()),
            "expected a smaller term, or another --steps"};
  }
}

}  // namespace

zed::SmtFinding decided(const zed::Term& predicate, const SeenText& text, zed::Steps& steps,
                        const zed::SmtProgram* solver, const std::function<OpenVariables()>& open) {
  if (solver == nullptr) {
    const zed::Truth truth = text.evaluator.holds(predicate, text.locals);
    if (truth == zed::Truth::open) throw open();
    return {truth};
  }
  const TruthByText by_text = truth_by_text(predicate, text, steps, open);
  if (by_text.truth != zed::Truth::open) return {by_text.truth};
  steps = zed::Steps(steps.most());
  zed::SmtFinding found;
  try {
    found = zed::ask_program(*solver, predicate, text.sections, text.evaluator, text.locals);
  } catch (const zed::StepsSpent&) {
    found.said = fmt::format("to evaluate what {} finds takes more than {} steps", solver->name, steps.most());
  }
  if (found.truth == zed::Truth::open) throw OpenVariables(by_text.why + "; " + found.said, by_text.expected);
  return found;
}

}  // namespace durero::spec
