/// A forward simulation: each concrete step from related states leads to related states.
#include <fmt/format.h>

#include "simulation.hpp"

namespace durero::spec {

using zed::Truth;
using zed::Valuation;

void Simulation::try_forward(std::size_t node, std::size_t i, const Inputs& inputs) {
  const OperationPair& pair = refinement_.operations[i];
  ObligationTrial& applies = trial_of(ObligationKind::applicability, i);
  ObligationTrial& agrees = trial_of(ObligationKind::correctness, i);
  const Valuation a = joined(nodes_[node].abstract, inputs), c = joined(nodes_[node].concrete, inputs);
  guarded(applies, [&] {
    Valuation step;
    const bool all = solutions_->each(pair.abstract, a, [&](const Valuation& found) {
      step = found;
      return false;
    });
    if (step.empty() && all) return;
    const Truth may = step.empty() ? Truth::open : Truth::yes;
    const Truth follows = may == Truth::yes ? solutions_->some(pair.concrete, c) : Truth::open;
    note(applies, follows, [&] {
      auto found = traces(node, why_not(pair.concrete, c));
      found.abstract.push_back(transition(pair.abstract, step, false));
      return found;
    });
    if (may == Truth::yes) guarded(agrees, [&] { try_steps(node, i, inputs); });
  });
}

void Simulation::try_steps(std::size_t node, std::size_t i, const Inputs& inputs) {
  const OperationPair& pair = refinement_.operations[i];
  ObligationTrial& agrees = trial_of(ObligationKind::correctness, i);
  const Valuation c = joined(nodes_[node].concrete, inputs);
  solutions_->each(pair.concrete, c, [&](const Valuation& done) {
    const Truth truth = functional_ ? the_abstract_step(node, i, done) : some_abstract_step(node, i, done);
    note(agrees, truth, [&] {
      std::string why = fmt::format("{} relates what {} has done to nothing that {} may do", refinement_.retrieve,
                                    pair.concrete, pair.abstract);
      auto found = traces(node, std::move(why));
      found.concrete.push_back(transition(pair.concrete, done, true));
      const Valuation before = joined(nodes_[node].abstract, done);
      solutions_->each(retrieve_after, done, [&](const Valuation& related) {
        found.why += fmt::format("; of the state that is related{}", because(pair.abstract, joined(before, related)));
        found.abstract.push_back(transition("(related by " + refinement_.retrieve + ")", related, false));
        return false;
      });
      return found;
    });
    return !agrees.counterexample;
  });
}

/// Goes on from the states after; a listed state is tried by itself.
void Simulation::go_on(std::size_t node, std::size_t i, const Valuation& done, const Valuation& allowed) {
  if (listing_) return;
  const OperationPair& pair = refinement_.operations[i];
  Transition by_a = transition(pair.abstract, allowed, false), by_c = transition(pair.concrete, done, true);
  Valuation a = by_a.after, c = by_c.after;
  add({std::move(a), std::move(c), node, std::move(by_a), std::move(by_c)});
}

Truth Simulation::some_abstract_step(std::size_t node, std::size_t i, const Valuation& done) {
  const Valuation before = joined(nodes_[node].abstract, done);
  bool found = false;
  const bool all = solutions_->each(done_and_related(i), before, [&](const Valuation& step) {
    found = true;
    go_on(node, i, done, step);
    return !listing_;
  });
  return found ? Truth::yes : all ? Truth::no : Truth::open;
}

Truth Simulation::the_abstract_step(std::size_t node, std::size_t i, const Valuation& done) {
  const Valuation before = joined(nodes_[node].abstract, done);
  Truth truth = Truth::yes;
  solutions_->each(retrieve_after, done, [&](const Valuation& related) {
    const Valuation step = joined(before, related);
    truth = solutions_->holds(refinement_.operations[i].abstract, step);
    if (truth == Truth::yes) go_on(node, i, done, step);
    return truth == Truth::yes;
  });
  return truth;
}

}  // namespace durero::spec
