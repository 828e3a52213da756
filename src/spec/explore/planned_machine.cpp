#include "planned_machine.hpp"

#include <algorithm>

namespace durero::spec {

using zed::Name;
using zed::Term;

namespace {

Name after_name(const Name& name) { return {name.word, name.strokes + "'"}; }

bool has_fact(const std::vector<Term>& facts, const Term& fact) {
  return std::find(facts.begin(), facts.end(), fact) != facts.end();
}

/// The facts that a schema text says: that each name is in its set, and its predicates.
std::vector<Term> all_facts(TermTranslator& translator, const zed::SchemaText& text) {
  std::vector<Term> facts;
  translator.add_facts(facts, text);
  return facts;
}

}  // namespace

PlannedMachine::PlannedMachine(const Machine& machine, NumberBounds numbers)
    : machine_(machine), translator_(machine.parts(), values_, numbers), rows_(0) {
  for (const Name& name : machine.components()) {
    state_places_.push_back(translator_.place());
    state_scope_.places.emplace(name, state_places_.back());
  }
  for (const MachineOperation& each : machine.operations()) {
    PlannedOperation operation;
    operation.name = each.name;
    operation.inputs = each.inputs;
    operation.outputs = each.outputs;
    operations_.push_back(std::move(operation));
  }
  initial_.name = machine.init().empty() ? machine.state() : machine.init();
}

void PlannedMachine::plan(bool split) {
  plan_invariant();
  for (PlannedOperation& operation : operations_) {
    plan(operation, false, split);
    fit();
  }
  plan(initial_, true, split);
  fit();
}

/// Translates what the state schema says of a state.
void PlannedMachine::plan_invariant() {
  const Term state = zed::reference(Name{machine_.state(), ""});
  if (const auto text = translator_.flat(state)) {
    keep_sequences(*text);
    state_facts_ = all_facts(translator_, *text);
    for (const Term& fact : state_facts_) invariant_.push_back(state_test(fact));
  } else {
    invariant_.push_back(state_test(state));
  }
  Term after = zed::make(
      {.kind = zed::Kind::decoration, .place = {}, .name = {"", "'"}, .children = {state}, .names = {}, .text = {}});
  if (const auto text = translator_.flat(after)) after_facts_ = all_facts(translator_, *text);
}

void PlannedMachine::keep_sequences(const zed::SchemaText& text) {
  for (const zed::Declaration& declaration : text.declarations) {
    zed::Value set;
    try {
      set = machine_.parts().evaluator->value(declaration.term);
    } catch (const zed::EvaluationError&) {  // its members are written as they were made
    }
    if (set.set() && set.set()->declares_sequences())
      for (const Name& name : declaration.names) sequences_.emplace(name, set);
  }
}

zed::Value PlannedMachine::written(const Name& name, ValueId id) const {
  const auto at = sequences_.find(name);
  return at == sequences_.end() ? values_.value(id) : at->second.set()->as_declared(values_.value(id));
}

/// The names of the state before are known, and all others of the operation are sought.
void PlannedMachine::plan(PlannedOperation& operation, bool is_initial, bool split) {
  const auto add = [&](const Name& name) {
    const auto [at, is_new] = operation.scope.places.emplace(name, 0);
    if (is_new) at->second = translator_.place();
    return at->second;
  };
  const auto text = translator_.flat(zed::reference(Name{operation.name, ""}));
  const auto declares = [&](const Name& name) {
    return text && std::any_of(text->declarations.begin(), text->declarations.end(), [&](const auto& each) {
             return std::find(each.names.begin(), each.names.end(), name) != each.names.end();
           });
  };
  const bool plain = is_initial && !declares(after_name(machine_.components().front()));
  for (const Name& name : machine_.components()) {
    if (!is_initial) operation.before.push_back(add(name));
    operation.after.push_back(add(plain ? name : after_name(name)));
  }
  for (const Name& name : operation.inputs) operation.given.push_back(add(name));
  for (const Name& name : operation.outputs) operation.returned.push_back(add(name));
  if (!text) return;
  keep_sequences(*text);
  try {
    SoughtNames sought{{}, {}, {}, {}};
    for (const zed::Declaration& declaration : text->declarations)
      for (const Name& name : declaration.names) {
        const bool known = !is_initial && state_scope_.places.contains(name);
        const unsigned at = add(name);
        if (!known) {
          sought.variables.emplace_back(at, translator_.domain_read(declaration.term, {}).code);
          sought.names.emplace_back(name, at);
        }
      }
    const std::vector<Term> facts = all_facts(translator_, *text);
    PlanWish wish{&operation.counts, state_facts_, {}, split, true};
    wish.uncounted.insert(wish.uncounted.end(), after_facts_.begin(), after_facts_.end());
    const bool whole_state =
        !is_initial && !state_facts_.empty() &&
        std::all_of(state_facts_.begin(), state_facts_.end(), [&](const Term& fact) { return has_fact(facts, fact); });
    if (whole_state) wish.held = state_facts_;
    operation.needs_invariant = whole_state;
    for (const zed::Declaration& declaration : text->declarations)
      for (const Name& name : declaration.names) {
        if (is_initial || !state_scope_.places.contains(name)) continue;
        sought.facts.push_back(member_of(name, declaration.term));
        wish.uncounted.push_back(sought.facts.back());
      }
    for (const zed::Predicate& predicate : text->predicates) translator_.add_facts(sought.facts, predicate.term);
    // Its own predicates are asked before those of the state schema, so that these do not answer for them.
    std::stable_partition(sought.facts.begin(), sought.facts.end(),
                          [&](const Term& fact) { return !has_fact(wish.uncounted, fact); });
    sought.scope = operation.scope;
    const auto plan = planned_search(translator_, sought, wish);
    for (const Name& name : plan->bounded())
      bounded_.insert(operation.name + ": some values of " + name.text() + " were tried: --numbers");
    for (const Term& fact : facts)
      if (!has_fact(wish.held, fact))
        operation.checks.push_back(translator_.predicate_read(fact, operation.scope).code);
    operation.plan = plan;
  } catch (const NotInterned&) {
    operation.counts.clear();
  } catch (const Undecided&) {
    operation.counts.clear();
  }
}

IdTest PlannedMachine::state_test(const Term& predicate) {
  IdTest test = translator_.predicate_read(predicate, state_scope_).code;
  fit();
  return test;
}

IdTest PlannedMachine::step_test(const PlannedOperation& operation, const Term& predicate) {
  IdTest test = translator_.predicate_read(predicate, operation.scope).code;
  fit();
  return test;
}

void PlannedMachine::load_state(std::span<const ValueId> state) {
  for (std::size_t i = 0; i < state.size(); ++i) frame_[state_places_[i]] = state[i];
}

bool PlannedMachine::invariant(std::span<const ValueId> state) {
  if (std::equal(state.begin(), state.end(), asked_.begin(), asked_.end())) return admitted_;
  load_state(state);
  asked_.clear();
  admitted_ = std::all_of(invariant_.begin(), invariant_.end(), [&](const IdTest& holds) { return holds(frame()); });
  asked_.assign(state.begin(), state.end());
  return admitted_;
}

void PlannedMachine::load(const PlannedOperation& operation, std::span<const ValueId> before,
                          std::span<const ValueId> row) {
  for (std::size_t i = 0; i < operation.before.size(); ++i) frame_[operation.before[i]] = before[i];
  std::size_t at = 0;
  for (const auto* places : {&operation.given, &operation.returned, &operation.after})
    for (const unsigned place : *places) frame_[place] = row[at++];
}

bool PlannedMachine::admits(const PlannedOperation& operation, std::span<const ValueId> before,
                            std::span<const ValueId> row) {
  if (operation.needs_invariant && !invariant(before)) return false;
  load(operation, before, row);
  return std::all_of(operation.checks.begin(), operation.checks.end(),
                     [&](const IdTest& holds) { return holds(frame()); });
}

StepRows& PlannedMachine::rows(PlannedOperation& operation, std::span<const ValueId> before) {
  rows_.reset(operation.width());
  if (!operation.plan) {
    evaluate(operation, before);
    return rows_;
  }
  for (std::size_t i = 0; i < operation.before.size(); ++i) frame_[operation.before[i]] = before[i];
  std::set<std::vector<ValueId>> seen;
  const bool repeats = operation.plan->repeats();
  auto& ids = rows_.ids();
  try {
    if (operation.needs_invariant && !invariant(before)) return rows_;
    operation.plan->each(frame(), [&] {
      const std::size_t begin = ids.size();
      for (const auto* places : {&operation.given, &operation.returned, &operation.after})
        for (const unsigned place : *places) ids.push_back(frame_[place]);
      const auto row = ids.begin() + static_cast<std::ptrdiff_t>(begin);
      if (repeats && !seen.emplace(row, ids.end()).second) ids.resize(begin);
      return true;
    });
  } catch (const NotInterned&) {
    evaluate(operation, before);
  } catch (const Undecided&) {
    evaluate(operation, before);
  }
  return rows_;
}

void PlannedMachine::each_side(
    PlannedOperation& operation, std::span<const ValueId> before,
    const std::function<void(const std::vector<Term>& sides, std::span<const ValueId> row)>& visit) {
  for (std::size_t i = 0; i < operation.before.size(); ++i) frame_[operation.before[i]] = before[i];
  std::vector<ValueId> row;
  try {
    if (operation.needs_invariant && !invariant(before)) return;
    operation.plan->each(frame(), [&] {
      row.clear();
      for (const auto* places : {&operation.given, &operation.returned, &operation.after})
        for (const unsigned place : *places) row.push_back(frame_[place]);
      visit(operation.plan->sides(), row);
      return true;
    });
  } catch (const NotInterned&) {
    bounded_.insert(operation.name + ": its cases are not decided");
  } catch (const Undecided&) {
    bounded_.insert(operation.name + ": its cases are not decided");
  }
}

/// Asks the evaluator for the steps.
void PlannedMachine::evaluate(const PlannedOperation& operation, std::span<const ValueId> before) {
  constexpr std::size_t most = 100'000;
  rows_.clear();
  try {
    const MachineOperation* of = machine_.find(operation.name);
    const ReachedTransitions found =
        operation.before.empty() ? machine_.initial(most) : machine_.steps(valuation(before), *of, {}, most);
    note(found, operation.name);
    for (const Transition& step : found.transitions) {
      std::vector<ValueId> row;
      for (const auto* values : {&step.inputs, &step.outputs, &step.after})
        for (const auto& [name, value] : *values) row.push_back(values_.of(value));
      if (row.size() == operation.width()) rows_.ids().insert(rows_.ids().end(), row.begin(), row.end());
    }
  } catch (const zed::EvaluationError&) {
    bounded_.insert(operation.name + ": the evaluator cannot follow its text");
  } catch (const NotInterned&) {
    bounded_.insert(operation.name + ": a value of it cannot be listed");
  } catch (const zed::StepsSpent&) {
    bounded_.insert(operation.name + ": --steps");
  }
}

void PlannedMachine::note(const ReachedTransitions& found, const std::string& what) {
  if (!found.bounded.empty()) bounded_.insert(what + ": " + found.bounded);
  if (!found.tried.empty())
    bounded_.insert(what + ": some values of " + name_list(found.tried) + " were tried: --numbers");
  else if (found.undecided)
    bounded_.insert(what + ": no equation gives all that it leaves open");
}

Transition PlannedMachine::transition(const PlannedOperation& operation, std::span<const ValueId> row) const {
  Transition step;
  step.operation = operation.name;
  std::size_t at = 0;
  for (const Name& name : operation.inputs) step.inputs.emplace_back(name, written(name, row[at++]));
  for (const Name& name : operation.outputs) step.outputs.emplace_back(name, written(name, row[at++]));
  step.after = valuation(row.subspan(at));
  return step;
}

zed::Valuation PlannedMachine::valuation(std::span<const ValueId> state) const {
  zed::Valuation all;
  for (std::size_t i = 0; i < state.size(); ++i)
    all.emplace_back(machine_.components()[i], written(machine_.components()[i], state[i]));
  return all;
}

std::vector<ValueId> PlannedMachine::ids(const zed::Valuation& state) {
  std::vector<ValueId> ids;
  for (const Name& name : machine_.components())
    for (const auto& [each, value] : state)
      if (each == name) ids.push_back(values_.of(value));
  return ids;
}

}  // namespace durero::spec
