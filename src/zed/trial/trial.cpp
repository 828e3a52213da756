#include "durero/zed/trial/trial.hpp"

#include <algorithm>
#include <utility>

#include "zed/trial/attempt.hpp"

namespace durero::zed {
namespace {

/// Says whether a conjecture is decided. An ∃ was tried where some state is a witness.
bool is_decided(const QuantifiedClaim& claim, const Trial& trial) {
  return !trial.counterexample.empty() || trial.is_evaluated || (claim.wants_witness && trial.tried > 0);
}

void refute_by_solver(const QuantifiedClaim& claim, const SmtFinding& found, Trial& trial) {
  if (claim.whole->kind == Kind::forall)
    for (const auto& [name, value] : found.values)
      trial.counterexample += "  " + name.text() + " = " + value.text() + "\n";
  if (trial.counterexample.empty()) trial.counterexample = "  " + found.said + "\n";
}

/// Asks the solver about a conjecture that states do not decide.
void ask_solver(const Ground& ground, const QuantifiedClaim& claim, const std::vector<Section>& sections,
                Trial& trial) {
  const SmtProgram& solver = *ground.bounds.solver;
  ground.steps = Steps(ground.bounds.steps);
  SmtFinding found;
  try {
    found = ask_program(solver, claim.whole, sections, ground.evaluator, {},
                        [&](const Name& set) { return ground.draw.names_in(set); });
  } catch (const StepsSpent&) {
    found.said = "to evaluate what " + solver.name + " finds takes too many steps";
  }
  trial.solver_said = found.said;
  if (found.truth == Truth::no) refute_by_solver(claim, found, trial);
  if (found.truth != Truth::yes) return;
  trial.is_evaluated = true;
  trial.tried = std::max<std::size_t>(trial.tried, 1);
  trial.why_not.clear();
}

/// One evaluator serves all, as what the text's own names stand for is the same for each; every conjecture has the
/// steps for itself.
void try_claims(std::vector<Section> sections, const Specification& specification, const Samples& samples,
                const std::vector<QuantifiedClaim>& claims, const Typing& typing, const TrialBounds& bounds,
                std::vector<Trial>& trials) {
  Steps steps(bounds.steps);
  const Evaluator evaluator(std::move(sections), bounds.constants, &steps);
  const Draw draw(specification, typing, samples, evaluator, bounds.numbers);
  Members members(evaluator, draw);
  const Ground ground{typing, draw, evaluator, bounds, members, steps, !samples.empty()};
  for (std::size_t i = 0; i < claims.size(); ++i) {
    Trial& trial = trials[i];
    steps = Steps(bounds.steps);
    try {
      Attempt(ground, claims[i]).run(trial);
    } catch (const EvaluationError& error) {
      if (trial.tried == 0) trial.why_not = error.what();
    } catch (const StepsSpent&) {
      if (trial.tried == 0) trial.why_not = "it takes more than " + std::to_string(bounds.steps) + " steps";
    }
    if (bounds.solver && !is_decided(claims[i], trial)) ask_solver(ground, claims[i], specification.sections, trial);
    trial.taken = evaluator.taken();
  }
}

}  // namespace

std::vector<Trial> try_conjectures(const Specification& specification, const Typing& typing, const Samples& samples,
                                   const TrialBounds& bounds) {
  std::vector<Trial> trials;
  std::vector<QuantifiedClaim> claims;
  std::vector<Section> sections;
  if (bounds.states > 0) sections = specification.sections;
  for (const Section& section : specification.sections) {
    Section own{section.file, "trial of " + section.name, {section.name}, {}, section.place, {}};
    for (const Paragraph& paragraph : section.paragraphs)
      if (const auto* conjecture = std::get_if<Conjecture>(&paragraph.form)) {
        trials.push_back({section.file, paragraph.place, conjecture->claim.label});
        if (bounds.states == 0) {
          trials.back().why_not = "no state is asked for";
          continue;
        }
        const QuantifiedClaim& claim = claims.emplace_back(conjecture->claim.term, claims.size());
        for (Paragraph& schema : claim.definitions()) own.paragraphs.push_back(std::move(schema));
      }
    sections.push_back(std::move(own));
  }
  if (!claims.empty()) try_claims(std::move(sections), specification, samples, claims, typing, bounds, trials);
  return trials;
}

}  // namespace durero::zed
