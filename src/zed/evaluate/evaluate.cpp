#include "durero/zed/evaluate/evaluate.hpp"

#include <algorithm>

#include "durero/zed/value/undecided.hpp"
#include "zed/evaluate/describe.hpp"
#include "zed/evaluate/evaluator_state.hpp"
#include "zed/value/functions.hpp"
#include "zed/value/sets.hpp"

namespace durero::zed {

struct SchemaCheck::State {
  State(Steps& counted, Compiler& of) : steps(counted), compiler(of) {}
  Steps& steps;
  Compiler& compiler;
  std::vector<Name> names;
  std::shared_ptr<Unit> unit;
  Property property;
  /// A conjunct before the last predicate, with the number of the declaration or predicate of the schema that has it.
  struct Conjunct {
    const Property* property;
    std::size_t part;
  };
  std::vector<Conjunct> before{};
  mutable std::size_t refuting = 0;  // the conjunct that was last found false

  void split() {
    if (property.kind != Property::Kind::all || property.parts.empty()) return;
    for (std::size_t i = 0; i + 1 < property.parts.size(); ++i) split(property.parts[i], i);
  }

  bool refutes(std::size_t i, Frame& frame) const {
    try {
      if (evaluate(*before[i].property, frame) != Truth::no) return false;
    } catch (const EvaluationError&) {
      return false;
    }
    refuting = i;
    return true;
  }

  Frame frame(std::span<const Value> values, Context& context) const {
    if (values.size() != names.size()) {
      throw EvaluationError("a schema of " + std::to_string(names.size()) + " components is given " +
                            std::to_string(values.size()));
    }
    Frame frame(unit->size, context);
    for (std::size_t i = 0; i < values.size(); ++i)  // what is not given is a value all the same
      frame.slots[i] = values[i].is_open() ? Value(Unknown{context.fresh()}) : values[i];
    return frame;
  }

 private:
  void split(const Property& conjunct, std::size_t part) {
    if (conjunct.kind != Property::Kind::all || conjunct.whole) return before.push_back({&conjunct, part});
    for (const Property& each : conjunct.parts) split(each, part);
  }
};

namespace {

struct Locals {
  std::shared_ptr<Unit> unit = std::make_shared<Unit>();
  Scope scope{.unit = unit};

  explicit Locals(const std::vector<Name>& names) {
    for (const Name& name : names) scope.names[name] = {Slots::take(*unit), {}};
  }
};

std::vector<Name> names_of(const Valuation& locals) {
  std::vector<Name> names;
  for (const auto& [name, value] : locals) names.push_back(name);
  return names;
}

Frame frame_of(const Valuation& locals, const Unit& unit, Context& context) {
  Frame frame(unit.size, context);
  for (std::size_t i = 0; i < locals.size(); ++i) frame.slots[i] = locals[i].second;
  return frame;
}

std::string text_of(const Property& property) {
  switch (property.written) {
    case Property::Written::no:
      return {};
    case Property::Written::term:
      return describe(*property.term);
    case Property::Written::member:
      return property.declares.text() + " ∈ " + describe(*property.term);
    case Property::Written::equal:
      return property.declares.text() + " = " + describe(*property.term);
  }
  __builtin_unreachable();  // it is written in one of these ways
}

ConjunctTruth finding(const Property& property, Truth here) {
  ConjunctTruth finding{property.label, text_of(property), property.strokes, {}, here};
  if (property.term) finding.place = property.term->place;
  return finding;
}

std::vector<ConjunctTruth> findings(const Property& property, Frame& frame);

long count(const std::vector<ConjunctTruth>& findings, Truth truth) {
  return std::count_if(findings.begin(), findings.end(),
                       [&](const ConjunctTruth& finding) { return finding.truth == truth; });
}

/// Returns the findings of the side of a disjunction that explains it best: it has the fewest false conjuncts, then the
/// fewest open.
std::vector<ConjunctTruth> best_side(const Property& property, Frame& frame) {
  std::vector<ConjunctTruth> best;
  for (std::size_t i = 0; i < property.parts.size(); ++i) {
    auto side = findings(property.parts[i], frame);
    const auto rank = [](const auto& of) { return std::pair(count(of, Truth::no), count(of, Truth::open)); };
    if (i == 0 || rank(side) < rank(best)) best = std::move(side);
  }
  return best;
}

std::vector<ConjunctTruth> findings(const Property& property, Frame& frame) {
  const bool composed = property.written == Property::Written::no;
  if (composed && property.kind == Property::Kind::any) return best_side(property, frame);
  if (composed && property.kind == Property::Kind::exists && property.search->determined()) {
    property.search->determine(frame);
    return findings(property.search->goal(), frame);
  }
  if (composed && property.kind == Property::Kind::all) {
    std::vector<ConjunctTruth> conjuncts;
    for (const Property& part : property.parts) {
      auto of_part = findings(part, frame);
      std::move(of_part.begin(), of_part.end(), std::back_inserter(conjuncts));
    }
    return conjuncts;
  }
  return {finding(property, evaluate(property, frame))};
}

}  // namespace

const std::vector<Name>& SchemaCheck::components() const { return state_->names; }

Truth SchemaCheck::holds(std::span<const Value> values) const {
  Context context(state_->steps);
  Frame frame = state_->frame(values, context);
  return evaluate(state_->property, frame);
}

SchemaCheck::Apart SchemaCheck::apart(std::span<const Value> values, const KnownTruth& known) const {
  Context context(state_->steps);
  for (const BindingPtr& binding : known.bindings) state_->compiler.remember(binding);
  Frame frame = state_->frame(values, context);
  const auto& before = state_->before;
  const auto is_known = [&](std::size_t i) { return !known.parts.empty() && known.parts[before[i].part]; };
  if (state_->refuting < before.size() && !is_known(state_->refuting) && state_->refutes(state_->refuting, frame))
    return {Truth::no, Truth::open};
  Apart found{Truth::yes, Truth::open};
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (is_known(i)) continue;
    found.before = both(found.before, evaluate(*before[i].property, frame));
    if (found.before != Truth::no) continue;
    state_->refuting = i;
    return found;
  }
  if (found.before == Truth::yes) found.last = evaluate(state_->property.parts.back(), frame);
  return found;
}

bool SchemaCheck::refuted(std::span<const Value> values, const KnownTruth& known) const {
  Context context(state_->steps);
  for (const BindingPtr& binding : known.bindings) state_->compiler.remember(binding);
  Frame frame = state_->frame(values, context);
  const auto& before = state_->before;
  const auto refutes = [&](std::size_t i) {
    return (known.parts.empty() || !known.parts[before[i].part]) && state_->refutes(i, frame);
  };
  if (state_->refuting < before.size() && refutes(state_->refuting)) return true;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (refutes(i)) return true;
  return false;
}

Truth SchemaCheck::last(std::span<const Value> values, const KnownTruth& known) const {
  Context context(state_->steps);
  for (const BindingPtr& binding : known.bindings) state_->compiler.remember(binding);
  Frame frame = state_->frame(values, context);
  return evaluate(state_->property.parts.back(), frame);
}

std::vector<ConjunctTruth> SchemaCheck::findings(std::span<const Value> values) const {
  Context context(state_->steps);
  Frame frame = state_->frame(values, context);
  return zed::findings(state_->property, frame);
}

Evaluator::Evaluator(std::vector<Section> sections, const Valuation& given, Steps* steps)
    : state_(std::make_unique<State>(std::move(sections), steps)) {
  for (const auto& [name, value] : given) {
    Meaning* global = state_->definitions.find(name);
    const bool carrier = global && global->kind == Meaning::Kind::given && value.set() && value.set()->members();
    if (!global || (global->kind != Meaning::Kind::axiomatic && !carrier)) {
      throw EvaluationError(name.text() + " is given a value, and is no name that the text leaves open");
    }
    global->value = value;
  }
}

Evaluator::~Evaluator() = default;
Evaluator::Evaluator(Evaluator&&) noexcept = default;
Evaluator& Evaluator::operator=(Evaluator&&) noexcept = default;

Value Evaluator::value(const Term& expression, const Valuation& locals) const {
  const Locals names(names_of(locals));
  const Code code = state_->compiler.expression(expression, names.scope);
  Context context(state_->steps);
  Frame frame = frame_of(locals, *names.unit, context);
  return code(frame);
}

Truth Evaluator::holds(const Term& predicate, const Valuation& locals) const {
  const Locals names(names_of(locals));
  const Property property = state_->compiler.predicate(predicate, names.scope);
  Context context(state_->steps);
  Frame frame = frame_of(locals, *names.unit, context);
  return evaluate(property, frame);
}

Value Evaluator::value(const Name& name) const { return value(reference(name)); }

std::vector<Value> Evaluator::some_members(const Value& set, const SmallScope& scope) const {
  Context context(state_->steps);
  return set.set() ? set.set()->some_members(scope, context) : std::vector<Value>();
}

Truth Evaluator::contains(const Value& set, const Value& value) const {
  Context context(state_->steps);
  return contains_value(set, value, context);
}

std::vector<Polynomial> Evaluator::comparisons(const Value& set, const std::function<Value(Unknown)>& value) const {
  Context context(state_->steps);
  Watch watch{context.fresh()};
  context.watch = &watch;
  const Truth here = contains_value(set, value(Unknown{watch.unknown}), context);
  if (watch.lost || (here == Truth::open && watch.compared.empty()))
    throw LackingEvaluation(Lack::degree,
                            "membership in " + set.text() + " depends on a number in a way that is not followed");
  return std::move(watch.compared);
}

Value Evaluator::apply(const Value& function, const Value& argument) const {
  Context context(state_->steps);
  return apply_value(function, argument, context);
}

std::vector<Name> Evaluator::constants() const { return state_->compiler.constants().names(); }

Valuation Evaluator::taken() const { return state_->compiler.constants().taken(); }

void Evaluator::check_given(const Name& constant) const {
  Context context(state_->steps);
  state_->compiler.constants().check(*state_->definitions.find(constant), context);
}

SchemaCheck Evaluator::schema(const Name& name) const {
  const auto names = components(reference(name), state_->definitions);
  if (!names) throw EvaluationError(name.text() + " is no schema");
  const Locals locals(*names);
  auto state = std::make_shared<SchemaCheck::State>(state_->steps, state_->compiler);
  state->names = *names;
  state->property = state_->compiler.predicate(reference(name), locals.scope);
  state->split();
  state->unit = locals.unit;
  SchemaCheck check;
  check.state_ = std::move(state);
  return check;
}

}  // namespace durero::zed
