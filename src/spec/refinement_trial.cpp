#include "durero/spec/refinement_trial.hpp"

#include <algorithm>
#include <utility>

#include "simulation.hpp"

namespace durero::spec {
namespace {

std::vector<ObligationTrial> untried(const Refinement& refinement, bool functional) {
  std::vector<ObligationTrial> trials;
  for (Obligation& each : obligations(refinement, functional)) trials.push_back({std::move(each), 0, 0, {}, {}});
  return trials;
}

bool is_of_retrieve(const Obligation& obligation) {
  return obligation.kind == ObligationKind::function || obligation.kind == ObligationKind::total;
}

bool held_in_each_case(const ObligationTrial& trial) {
  return trial.held > 0 && trial.open == 0 && !trial.counterexample;
}

/// Tries the obligation of the retrieve schema alone in every scope.
ObligationTrial retrieve_trial(const zed::Specification& text, const Refinement& refinement,
                               const RefinementBounds& bounds, bool functional) {
  std::vector<ObligationTrial> all = untried(refinement, functional);
  ObligationTrial trial = std::move(all.front());
  for (std::size_t scope = 1; scope <= bounds.scope && !trial.counterexample; ++scope) {
    Simulation simulation(text, refinement, bounds, scope, all);
    if (simulation.is_possible()) simulation.try_retrieve(trial);
  }
  return trial;
}

}  // namespace

bool RefinementTrial::holds() const { return std::ranges::all_of(all, held_in_each_case); }

// The rules of a retrieve function are taken where it is found to be one in every case, and else those of a relation.
RefinementTrial try_refinement(const zed::Specification& text, const Refinement& refinement,
                               const RefinementBounds& bounds) {
  RefinementTrial result;
  ObligationTrial of_retrieve = retrieve_trial(text, refinement, bounds, !refinement.backward);
  result.functional = !refinement.backward && held_in_each_case(of_retrieve);
  result.all = untried(refinement, result.functional);
  if (is_of_retrieve(result.all.front().obligation)) result.all.front() = std::move(of_retrieve);
  for (std::size_t scope = 1; scope <= bounds.scope; ++scope) {
    Simulation simulation(text, refinement, bounds, scope, result.all);
    if (simulation.is_possible()) simulation.run(result.functional);
    result.bounds.push_back(simulation.bounds_line());
    result.taken = simulation.taken();
  }
  return result;
}

}  // namespace durero::spec
