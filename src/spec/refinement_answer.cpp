/// The answer of a refinement's trial, as text.
#include <fmt/format.h>

#include <algorithm>

#include "durero/spec/animation_text.hpp"
#include "durero/spec/refinement_trial.hpp"

namespace durero::spec {
namespace {

std::string cases(std::size_t count) { return fmt::format("{} case{}", count, count == 1 ? "" : "s"); }

std::string verdict_of(const ObligationTrial& trial) {
  if (trial.counterexample) return "is false, as shown below";
  if (trial.held == 0 && trial.open == 0) return "NOT TRIED: no case of it was found";
  if (trial.held == 0) return fmt::format("NOT TRIED: {} not decided: {}", cases(trial.open), trial.why_open);
  if (trial.open > 0)
    return fmt::format("holds in {}, but {} NOT DECIDED: {}", cases(trial.held), cases(trial.open), trial.why_open);
  return fmt::format("holds in {}", cases(trial.held));
}

std::string subject_of(const Refinement& refinement, const Obligation& obligation) {
  if (obligation.operation == refinement.operations.size()) return obligation_word(obligation.kind);
  const OperationPair& pair = refinement.operations[obligation.operation];
  return fmt::format("{} of {}", obligation_word(obligation.kind), pair.abstract);
}

std::string heading(const Refinement& refinement, bool functional) {
  const char* by = refinement.backward ? "backward" : functional ? "forward, by a retrieve function" : "forward";
  std::string said =
      fmt::format("{} by {}, related by {}: {}\n", refinement.abstract, refinement.concrete, refinement.retrieve, by);
  said += fmt::format("  {} by {}\n", refinement.abstract_init, refinement.concrete_init);
  for (const OperationPair& pair : refinement.operations)
    said += fmt::format("  {} by {}\n", pair.abstract, pair.concrete);
  for (const std::string& name : refinement.alone) said += fmt::format("  {} has NO PARTNER\n", name);
  return said;
}

std::string table_of(const Refinement& refinement, const RefinementTrial& trial) {
  std::size_t labels = 0, subjects = 0;
  for (const ObligationTrial& each : trial.all) {
    labels = std::max(labels, each.obligation.label.size());
    subjects = std::max(subjects, subject_of(refinement, each.obligation).size());
  }
  std::string said;
  for (const ObligationTrial& each : trial.all)
    said += fmt::format("{:<{}}  {:<{}}  {}\n", each.obligation.label, labels, subject_of(refinement, each.obligation),
                        subjects, verdict_of(each));
  return said;
}

/// The states of a text in the scope of a counterexample, for the values to be written by.
Machine machine_of(const zed::Specification& text, const std::string& state, const RefinementBounds& bounds,
                   std::size_t scope) {
  Setup setup;
  setup.state = state;
  setup.given = bounds.given;
  setup.constants = bounds.constants;
  setup.members = scope;
  return Machine(text, std::move(setup));
}

std::string counterexample_text(const zed::Specification& text, const Refinement& refinement,
                                const RefinementBounds& bounds, const ObligationTrial& trial) {
  const RefinementCounterexample& found = *trial.counterexample;
  const Machine a = machine_of(text, refinement.abstract, bounds, found.scope);
  const Machine c = machine_of(text, refinement.concrete, bounds, found.scope);
  std::string said = fmt::format("\n{}, {}, is false: {}.\n", trial.obligation.label,
                                 subject_of(refinement, trial.obligation), found.why);
  for (const std::string& carrier : c.carriers()) said += "  " + carrier + "\n";
  if (!found.abstract.empty()) said += fmt::format("{}:\n{}", refinement.abstract, way_story(a, found.abstract));
  return said + fmt::format("{}:\n{}", refinement.concrete, way_story(c, found.concrete));
}

}  // namespace

std::string refinement_answer(const zed::Specification& text, const Refinement& refinement,
                              const RefinementBounds& bounds, const RefinementTrial& trial) {
  std::string said = heading(refinement, trial.functional) + table_of(refinement, trial);
  for (const std::string& line : trial.bounds) said += line + "\n";
  for (const ObligationTrial& each : trial.all)
    if (each.counterexample) said += counterexample_text(text, refinement, bounds, each);
  return said;
}

}  // namespace durero::spec
