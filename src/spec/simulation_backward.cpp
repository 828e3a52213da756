/// A backward simulation: each concrete step to a state that is related comes from one that is.
#include <fmt/format.h>

#include "simulation.hpp"

namespace durero::spec {

using zed::Truth;
using zed::Valuation;

/// Each abstract state that is related to a first concrete one is a first one.
void Simulation::begin_backward(const Valuation& first) {
  const Transition begun = transition(refinement_.concrete_init, first, true);
  ObligationTrial& trial = trial_of(ObligationKind::initialisation, refinement_.operations.size());
  solutions_->each(retrieve_after, first, [&](const Valuation& related) {
    note(trial, solutions_->holds(first_of_abstract, related), [&] {
      const std::string why = fmt::format("{} relates this state to one that is none of {}{}", refinement_.retrieve,
                                          refinement_.abstract_init, because(first_of_abstract, related));
      return RefinementCounterexample{
          scope_, true, {transition("(related by " + refinement_.retrieve + ")", related, false)}, {begun}, why};
    });
    return !trial.counterexample;
  });
  add({{}, begun.after, nodes_.size() + 1, {}, begun});
}

Truth Simulation::abstract_always_may(const Valuation& concrete, std::size_t i, const Inputs& inputs) {
  Truth each = Truth::yes;
  const bool all = solutions_->each(refinement_.retrieve, concrete, [&](const Valuation& related) {
    const Truth may = solutions_->some(refinement_.operations[i].abstract, joined(related, inputs));
    if (may != Truth::yes) each = may;
    return may != Truth::no;
  });
  return each == Truth::yes && !all ? Truth::open : each;
}

void Simulation::try_backward(std::size_t node, std::size_t i, const Inputs& inputs) {
  const OperationPair& pair = refinement_.operations[i];
  ObligationTrial& applies = trial_of(ObligationKind::applicability, i);
  const Valuation c = joined(nodes_[node].concrete, inputs);
  guarded(applies, [&] {
    const Truth asked = abstract_always_may(nodes_[node].concrete, i, inputs);
    if (asked != Truth::no) {
      const Truth follows = asked == Truth::yes ? solutions_->some(pair.concrete, c) : Truth::open;
      note(applies, follows, [&] {
        auto found = traces(node, why_not(pair.concrete, c));
        found.why += fmt::format(", and {} may in each state that is related", pair.abstract);
        return found;
      });
    }
    guarded(trial_of(ObligationKind::correctness, i), [&] { try_steps_back(node, i, inputs); });
  });
}

/// Steps are gone on by wherever they lead; the obligation speaks of those from states where the abstract one may.
void Simulation::try_steps_back(std::size_t node, std::size_t i, const Inputs& inputs) {
  const OperationPair& pair = refinement_.operations[i];
  const Truth asked = abstract_always_may(nodes_[node].concrete, i, inputs);
  solutions_->each(pair.concrete, joined(nodes_[node].concrete, inputs), [&](const Valuation& done) {
    if (asked == Truth::yes) try_step_back(node, i, done);
    if (asked == Truth::open) note(trial_of(ObligationKind::correctness, i), asked, {});
    if (!listing_) {
      Transition by_c = transition(pair.concrete, done, true);
      Valuation c = by_c.after;
      add({{}, std::move(c), node, {}, std::move(by_c)});
    }
    return true;
  });
}

void Simulation::try_step_back(std::size_t node, std::size_t i, const Valuation& done) {
  const OperationPair& pair = refinement_.operations[i];
  ObligationTrial& agrees = trial_of(ObligationKind::correctness, i);
  solutions_->each(retrieve_after, done, [&](const Valuation& related) {
    const Valuation step = joined(done, related);
    note(agrees, solutions_->some(related_and_done(i), step), [&] {
      auto found =
          traces(node, fmt::format("no step of {} to this state begins where {} relates a state to the one before",
                                   pair.abstract, refinement_.retrieve));
      found.concrete.push_back(transition(pair.concrete, done, true));
      found.abstract.push_back(transition(fmt::format("(related by {})", refinement_.retrieve), step, false));
      return found;
    });
    return !agrees.counterexample;
  });
}

}  // namespace durero::spec
