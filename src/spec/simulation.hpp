#pragma once
/// One scope of the trial of a refinement.

#include <functional>
#include <memory>

#include "durero/spec/refinement_trial.hpp"
#include "scoped_solutions.hpp"

namespace durero::spec {

/// The schemas beside the text's own that a trial asks, as a section that sees all of it.
zed::Section simulation_section(const zed::Specification& text, const Refinement& refinement);

/// @{ The names of those schemas, which no text can write: R ′, AINIT and CINIT of states after, AINIT ∧ R ′, and for
/// the operation pair i, R ′ ∧ AOP and R ∧ AOP.
inline const std::string retrieve_after = " retrieve after";
inline const std::string first_of_abstract = " first abstract";
inline const std::string first_of_concrete = " first concrete";
inline const std::string first_related = " first related";
std::string done_and_related(std::size_t i);
std::string related_and_done(std::size_t i);
/// @}

/// Tries the obligations of one refinement in one scope, and adds what it finds to the results.
class Simulation {
 public:
  /// `trials` are those of obligations(), and outlive it, as the rest does. Throws what Machine does.
  Simulation(const zed::Specification& text, const Refinement& refinement, const RefinementBounds& bounds,
             std::size_t scope, std::vector<ObligationTrial>& trials);
  /// Whether the constants of the text may have values in the scope; if not, the text says nothing of it.
  bool is_possible() const;
  /// Tries whether the retrieve schema is a function, or total, on the concrete states in the scope.
  void try_retrieve(ObligationTrial& trial);
  /// Tries the others.
  void run(bool functional);
  /// The scope in words.
  std::string bounds_line() const;
  /// The lines of constants for which a value was taken.
  std::vector<std::string> taken() const;

 private:
  /// A pair of states with how it was come to; in a backward simulation the concrete state alone.
  struct Node {
    zed::Valuation abstract, concrete;
    std::size_t parent;  ///< of a first one, itself
    Transition by_abstract, by_concrete;
  };
  struct StatesBefore {
    bool operator()(const std::vector<zed::Value>& a, const std::vector<zed::Value>& b) const;
  };
  using Inputs = zed::Valuation;
  using Traces = std::function<RefinementCounterexample()>;

  void try_related(ObligationTrial& trial, const zed::Valuation& concrete, std::size_t most);
  void begin();
  void begin_related(const zed::Valuation& first);
  void list_states();
  void try_listed(const zed::Valuation& abstract, const zed::Valuation& concrete);
  void add(Node node);
  void try_at(std::size_t node);
  void each_input(std::size_t i, const std::function<void(const Inputs&)>& visit);
  ObligationTrial& trial_of(ObligationKind kind, std::size_t operation);
  void note(ObligationTrial& trial, zed::Truth truth, const Traces& refuted);
  RefinementCounterexample traces(std::size_t node, std::string why) const;
  Transition transition(const std::string& operation, const zed::Valuation& binding, bool concrete) const;
  std::string first_false(const std::string& schema, const zed::Valuation& values) const;
  std::string why_not(const std::string& operation, const zed::Valuation& values) const;
  std::string because(const std::string& schema, const zed::Valuation& values) const;
  template <class Question>
  void guarded(ObligationTrial& of, Question&& question);

  // A forward simulation is tried in simulation_forward.cpp.
  void try_forward(std::size_t node, std::size_t i, const Inputs& inputs);
  void try_steps(std::size_t node, std::size_t i, const Inputs& inputs);
  zed::Truth some_abstract_step(std::size_t node, std::size_t i, const zed::Valuation& done);
  zed::Truth the_abstract_step(std::size_t node, std::size_t i, const zed::Valuation& done);
  void go_on(std::size_t node, std::size_t i, const zed::Valuation& done, const zed::Valuation& allowed);

  // A backward simulation is tried in simulation_backward.cpp.
  void begin_backward(const zed::Valuation& first);
  void try_backward(std::size_t node, std::size_t i, const Inputs& inputs);
  zed::Truth abstract_always_may(const zed::Valuation& concrete, std::size_t i, const Inputs& inputs);
  void try_steps_back(std::size_t node, std::size_t i, const Inputs& inputs);
  void try_step_back(std::size_t node, std::size_t i, const zed::Valuation& done);

  const Refinement& refinement_;
  const RefinementBounds& bounds_;
  std::size_t scope_;
  std::vector<ObligationTrial>& trials_;
  std::unique_ptr<Machine::Parts> parts_;
  std::vector<zed::Name> abstract_names_, concrete_names_;
  std::unique_ptr<ScopedSolutions> solutions_;
  bool functional_ = false, listing_ = false;
  std::vector<Node> nodes_;
  std::set<std::vector<zed::Value>, StatesBefore> met_;
  std::size_t reached_ = 0, listed_ = 0;
  bool all_reached_ = true, all_listed_ = true;
};

/// Asks a question of obligations; it is open for them where it cannot be decided.
template <class Question>
void Simulation::guarded(ObligationTrial& of, Question&& question) {
  try {
    question();
  } catch (const zed::EvaluationError& error) {
    ++of.open;
    of.why_open = error.what();
  } catch (const zed::StepsSpent&) {
    ++of.open;
    of.why_open = "it takes more than " + std::to_string(bounds_.steps) + " steps";
  }
}

/// @{ The values by the names of the state after, or by those of the state before.
zed::Valuation after_names(const zed::Valuation& state);
zed::Valuation plain_names(const zed::Valuation& binding, const std::vector<zed::Name>& components);
/// @}
/// All values of several valuations.
zed::Valuation joined(const zed::Valuation& a, const zed::Valuation& b);

}  // namespace durero::spec
