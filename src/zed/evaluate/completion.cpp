#include <algorithm>

#include "durero/zed/evaluate/evaluate.hpp"
#include "zed/evaluate/evaluator_state.hpp"

namespace durero::zed {

struct Completion::State {
  explicit State(Steps& counted) : steps(counted) {}
  Steps& steps;
  std::vector<Name> sought;
  std::vector<unsigned> slots;  // in step with sought
  std::size_t known = 0;        // these have the first slots
  std::shared_ptr<Unit> unit = std::make_shared<Unit>();
  std::vector<Solver> sides;
};

namespace {

/// The value as it is written where it is declared from the set of the variable.
Value written_as_declared(const Value& value, const Variable& variable, Frame& frame) {
  if (!value.set() && !value.tuple()) return value;
  const Value set = variable.set ? variable.set(frame) : Value();
  return set.set() && set.set()->declares_sequences() ? set.set()->as_declared(value) : value;
}

}  // namespace

const std::vector<Name>& Completion::sought() const { return state_->sought; }

struct Completion::Visited {
  const State& state;
  Context context;
  Frame frame;
  Visited(const State& of, std::span<const Value> known) : state(of), context(of.steps), frame(of.unit->size, context) {
    if (known.size() != of.known) throw EvaluationError("a completion is given too many values, or too few");
    std::copy(known.begin(), known.end(), frame.slots.begin());
  }
  std::vector<Value> sought(const Solver& side, Frame& inside) const {
    std::vector<Value> values;
    for (std::size_t i = 0; i < state.slots.size(); ++i)
      values.push_back(written_as_declared(inside.slots[state.slots[i]], side.variables()[i], inside));
    return values;
  }
};

Truth Completion::each(std::span<const Value> known,
                       const std::function<bool(std::span<const Value> sought)>& visit) const {
  Visited visited(*state_, known);
  Truth found = Truth::no;
  bool stopped = false;
  for (const Solver& side : state_->sides) {
    const Truth here = side.each(visited.frame, [&](Frame& inside) {
      stopped = !visit(visited.sought(side, inside));
      return !stopped;
    });
    if (here == Truth::open || found == Truth::no) found = here;
    if (stopped) break;
  }
  return found;
}

Truth Completion::first(std::span<const Value> known,
                        const std::function<void(std::span<const Value> sought)>& visit) const {
  Visited visited(*state_, known);
  Truth found = Truth::no;
  for (const Solver& one : state_->sides) {
    const Truth here = one.first(visited.frame, [&](Frame& inside) {
      visit(visited.sought(one, inside));
      return false;
    });
    if (here == Truth::yes) return here;
    if (here == Truth::open) found = here;
  }
  return found;
}

Completion Evaluator::completion(const Name& schema, const std::vector<Name>& known) const {
  const auto names = components(reference(schema), state_->definitions);
  if (!names) throw EvaluationError(schema.text() + " is no schema");
  auto state = std::make_shared<Completion::State>(state_->steps);
  Scope scope{.unit = state->unit};
  state->known = known.size();
  for (const Name& name : known) scope.names[name] = {Slots::take(*state->unit), {}};
  std::vector<Variable> variables;
  for (const Name& name : *names) {
    if (scope.names.contains(name)) continue;
    const unsigned slot = Slots::take(*state->unit);
    scope.names[name] = {slot, {}};
    state->sought.push_back(name);
    state->slots.push_back(slot);
    variables.push_back({.name = name.text(), .slot = slot, .set = {}, .value = {}});
  }
  const Property property = state_->compiler.predicate(reference(schema), scope);
  for (Property& side : sides_of(property)) state->sides.emplace_back(variables, std::move(side));
  Completion completion;
  completion.state_ = std::move(state);
  return completion;
}

}  // namespace durero::zed
