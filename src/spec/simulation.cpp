#include "simulation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "durero/spec/constants.hpp"

namespace durero::spec {

using zed::Name;
using zed::Truth;
using zed::Valuation;
using zed::Value;

Valuation after_names(const Valuation& state) {
  Valuation after;
  for (const auto& [name, value] : state) after.emplace_back(Name{name.word, name.strokes + "'"}, value);
  return after;
}

Valuation plain_names(const Valuation& binding, const std::vector<Name>& components) {
  Valuation state;
  for (const Name& name : components)
    for (const auto& [given, value] : binding)
      if (given == Name{name.word, name.strokes + "'"}) state.emplace_back(name, value);
  return state;
}

Valuation joined(const Valuation& a, const Valuation& b) {
  Valuation all = a;
  all.insert(all.end(), b.begin(), b.end());
  return all;
}

namespace {

Valuation values_of_names(const Valuation& binding, const std::vector<Name>& components) {
  Valuation state;
  for (const Name& name : components)
    for (const auto& [given, value] : binding)
      if (given == name) state.emplace_back(name, value);
  return state;
}

std::vector<Value> values_alone(const Valuation& a, const Valuation& b) {
  std::vector<Value> values;
  for (const auto* state : {&a, &b})
    for (const auto& [name, value] : *state) values.push_back(value);
  return values;
}

/// The most choices of an operation's inputs that are tried in one state.
constexpr std::size_t most_inputs = 64;

}  // namespace

bool Simulation::StatesBefore::operator()(const std::vector<Value>& a, const std::vector<Value>& b) const {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [](const Value& x, const Value& y) { return zed::compare(x, y) < 0; });
}

Simulation::Simulation(const zed::Specification& text, const Refinement& refinement, const RefinementBounds& bounds,
                       std::size_t scope, std::vector<ObligationTrial>& trials)
    : refinement_(refinement), bounds_(bounds), scope_(scope), trials_(trials) {
  zed::Specification with = text;
  with.sections.push_back(simulation_section(text, refinement));
  Setup setup;
  setup.state = refinement.concrete;
  setup.given = bounds.given;
  setup.constants = bounds.constants;
  setup.members = scope;
  setup.steps = bounds.steps;
  parts_ = std::make_unique<Machine::Parts>(with, std::move(setup));
  abstract_names_ = parts_->check(refinement.abstract).components();
  concrete_names_ = parts_->check(refinement.concrete).components();
  solutions_ = std::make_unique<ScopedSolutions>(*parts_, scope);
}

std::vector<std::string> Simulation::taken() const { return taken_lines(parts_->evaluator->taken()); }

bool Simulation::is_possible() const {
  for (const Name& constant : parts_->evaluator->constants()) try {
      parts_->begin_question();
      parts_->evaluator->value(constant);
    } catch (const zed::Unsatisfied&) {
      return false;
    } catch (const zed::EvaluationError&) {  // whoever needs its value is told so
    } catch (const zed::StepsSpent&) {
    }
  return true;
}

std::string Simulation::bounds_line() const {
  if (!is_possible()) return fmt::format("scope {}: the constants of the text have no values in it", scope_);
  const char* what = refinement_.backward ? "states" : "pairs of states";
  return fmt::format("scope {}: {} {} reached{}, {} states listed{}", scope_, reached_, what,
                     all_reached_ ? ", all that these inputs lead to" : "", listed_,
                     all_listed_ ? ", all of this scope" : "");
}

ObligationTrial& Simulation::trial_of(ObligationKind kind, std::size_t operation) {
  return *std::find_if(trials_.begin(), trials_.end(), [&](const ObligationTrial& trial) {
    return trial.obligation.kind == kind && trial.obligation.operation == operation;
  });
}

void Simulation::note(ObligationTrial& trial, Truth truth, const Traces& refuted) {
  switch (truth) {
    case Truth::yes:
      ++trial.held;
      return;
    case Truth::open:
      ++trial.open;
      trial.why_open = solutions_->why_open();
      return;
    case Truth::no:
      if (!trial.counterexample) trial.counterexample = refuted();
      return;
  }
}

Transition Simulation::transition(const std::string& operation, const Valuation& binding, bool concrete) const {
  Transition made{operation, {}, {}, plain_names(binding, concrete ? concrete_names_ : abstract_names_)};
  for (const auto& [name, value] : binding) {
    if (name.strokes.ends_with("?")) made.inputs.emplace_back(name, value);
    if (name.strokes.ends_with("!")) made.outputs.emplace_back(name, value);
  }
  return made;
}

RefinementCounterexample Simulation::traces(std::size_t node, std::string why) const {
  RefinementCounterexample found{scope_, !listing_, {}, {}, std::move(why)};
  for (std::size_t at = node;; at = nodes_[at].parent) {
    if (!nodes_[at].abstract.empty()) found.abstract.push_back(nodes_[at].by_abstract);
    found.concrete.push_back(nodes_[at].by_concrete);
    if (nodes_[at].parent == at) break;
  }
  std::reverse(found.abstract.begin(), found.abstract.end());
  std::reverse(found.concrete.begin(), found.concrete.end());
  return found;
}

/// The first conjunct of the schema that these values make false, if one is found to be.
std::string Simulation::first_false(const std::string& schema, const Valuation& values) const {
  parts_->begin_question();
  try {
    const zed::SchemaCheck& check = parts_->check(schema);
    for (const zed::ConjunctTruth& finding : check.findings(in_order(check.components(), values)))
      if (finding.truth == Truth::no) return finding.predicate;
  } catch (const zed::EvaluationError&) {  // it is false as a whole
  }
  return {};
}

std::string Simulation::because(const std::string& schema, const Valuation& values) const {
  const std::string predicate = first_false(schema, values);
  return predicate.empty() ? "" : ": false is " + predicate;
}

std::string Simulation::why_not(const std::string& operation, const Valuation& values) const {
  const std::string predicate = first_false(operation, values);
  return fmt::format("{} may not follow: {}", operation,
                     predicate.empty() ? "no state after satisfies it" : "false is " + predicate);
}

void Simulation::add(Node node) {
  if (nodes_.size() >= bounds_.states) {
    all_reached_ = false;
    return;
  }
  if (!met_.insert(values_alone(node.abstract, node.concrete)).second) return;
  if (node.parent == nodes_.size() + 1) node.parent = nodes_.size();
  nodes_.push_back(std::move(node));
}

void Simulation::try_retrieve(ObligationTrial& trial) {
  const bool one = trial.obligation.kind == ObligationKind::function;
  guarded(trial, [&] {
    for (const Valuation& binding : solutions_->sample(refinement_.concrete, bounds_.states).bindings)
      if (!trial.counterexample)
        guarded(trial, [&] { try_related(trial, values_of_names(binding, concrete_names_), one ? 2 : 1); });
  });
}

/// Counts the related states, up to as many as tell; of a function there is one, and two of no function.
void Simulation::try_related(ObligationTrial& trial, const Valuation& c, std::size_t most) {
  std::size_t count = 0;
  const bool all = solutions_->each(refinement_.retrieve, c, [&](const Valuation&) { return ++count < most; });
  Truth truth = Truth::yes;
  if (count == 0) truth = all ? Truth::no : Truth::open;
  if (most == 2 && count == 1 && !all) truth = Truth::open;
  if (count == 2) truth = Truth::no;
  note(trial, truth, [&] {
    const std::string why = fmt::format("{} relates {} of {} to this state", refinement_.retrieve,
                                        count == 0 ? "no state" : "two states", refinement_.abstract);
    return RefinementCounterexample{scope_, false, {}, {{refinement_.concrete, {}, {}, c}}, why};
  });
}

void Simulation::run(bool functional) {
  functional_ = functional;
  begin();
  for (std::size_t at = 0; at < nodes_.size(); ++at) try_at(at);
  reached_ = nodes_.size();
  list_states();
}

void Simulation::begin() {
  ObligationTrial& trial = trial_of(ObligationKind::initialisation, refinement_.operations.size());
  guarded(trial, [&] {
    // A quarter of the states may be first ones, so that steps are tried too.
    const ScopedSample first = solutions_->sample(first_of_concrete, std::max<std::size_t>(1, bounds_.states / 4));
    all_reached_ = first.all;
    for (const Valuation& state : first.bindings)
      guarded(trial, [&] { refinement_.backward ? begin_backward(state) : begin_related(state); });
  });
}

/// Of a forward simulation: some first abstract state is related to this one, or of a function the state that is.
void Simulation::begin_related(const Valuation& first) {
  const Transition begun = transition(refinement_.concrete_init, first, true);
  ObligationTrial& trial = trial_of(ObligationKind::initialisation, refinement_.operations.size());
  std::string why = fmt::format("{} relates this state to none of {}", refinement_.retrieve, refinement_.abstract_init);
  Truth truth = Truth::open;  // until a related state is found
  const std::string& related = functional_ ? retrieve_after : first_related;
  const bool all = solutions_->each(related, first, [&](const Valuation& binding) {
    const Truth here = functional_ ? solutions_->holds(first_of_abstract, binding) : Truth::yes;
    if (here == Truth::yes)
      add({plain_names(binding, abstract_names_), begun.after, nodes_.size() + 1,
           transition(refinement_.abstract_init, binding, false), begun});
    truth = here;
    if (here == Truth::no) why += because(first_of_abstract, binding);
    return here == Truth::yes && nodes_.size() < bounds_.states;
  });
  if (truth == Truth::open && all) truth = Truth::no;
  note(trial, truth, [&] { return RefinementCounterexample{scope_, true, {}, {begun}, why}; });
}

/// The concrete states in the scope, reached or not, and what they stand for.
void Simulation::list_states() {
  listing_ = true;
  ScopedSample states;
  ObligationTrial unnoted{};  // what the obligations ask of states is noted where it is asked
  guarded(unnoted, [&] { states = solutions_->sample(refinement_.concrete, bounds_.states); });
  all_listed_ = states.all;
  for (const Valuation& binding : states.bindings) {
    const Valuation c = values_of_names(binding, concrete_names_);
    if (refinement_.backward) {
      try_listed({}, c);
      continue;
    }
    guarded(unnoted, [&] {
      solutions_->each(refinement_.retrieve, c, [&](const Valuation& both) {
        try_listed(values_of_names(both, abstract_names_), c);
        return listed_ < bounds_.states;
      });
    });
  }
  all_listed_ = all_listed_ && listed_ < bounds_.states;
}

void Simulation::try_listed(const Valuation& a, const Valuation& c) {
  if (listed_ >= bounds_.states || !met_.insert(values_alone(a, c)).second) return;
  ++listed_;
  const std::string of = " (any state, reached or not)";
  nodes_.push_back(
      {a, c, nodes_.size(), {refinement_.abstract + of, {}, {}, a}, {refinement_.concrete + of, {}, {}, c}});
  try_at(nodes_.size() - 1);
  nodes_.pop_back();
}

void Simulation::each_input(std::size_t i, const std::function<void(const Inputs&)>& visit) {
  const OperationPair& pair = refinement_.operations[i];
  std::vector<Inputs> rows{{}};
  for (const auto& [name, set] : pair.inputs) {
    std::vector<Inputs> longer;
    for (const Inputs& row : rows)
      for (const Value& value : solutions_->members(pair.abstract, name).values) {
        if (longer.size() >= most_inputs) break;
        longer.push_back(row);
        longer.back().emplace_back(name, value);
      }
    rows = std::move(longer);
  }
  for (const Inputs& row : rows) visit(row);
}

void Simulation::try_at(std::size_t node) {
  for (std::size_t i = 0; i < refinement_.operations.size(); ++i)
    each_input(i, [&](const Inputs& inputs) {
      refinement_.backward ? try_backward(node, i, inputs) : try_forward(node, i, inputs);
    });
}

}  // namespace durero::spec
