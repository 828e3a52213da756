/// How a text is read as a machine, and what its operations do.
#include <algorithm>
#include <stdexcept>

#include "claims.hpp"
#include "durero/spec/animation.hpp"
#include "durero/spec/constants.hpp"
#include "machine_parts.hpp"
#include "ways.hpp"

namespace durero::spec {

using zed::Name;
using zed::Truth;
using zed::Type;
using zed::Valuation;
using zed::Value;

namespace {

Name after_stroke(const Name& name) { return {name.word, name.strokes + "'"}; }

bool has_name(const std::vector<Name>& names, const Name& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool has_all(const std::vector<Name>& names, const std::vector<Name>& wanted) {
  return std::all_of(wanted.begin(), wanted.end(), [&](const Name& name) { return has_name(names, name); });
}

bool same_given(const Valuation& a, const Valuation& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.first == y.first && zed::same(x.second, y.second); });
}

const Value* value_of(const Valuation& given, const Name& name) {
  const auto at = std::find_if(given.begin(), given.end(), [&](const auto& each) { return each.first == name; });
  return at == given.end() ? nullptr : &at->second;
}

}  // namespace

bool Transition::operator==(const Transition& other) const {
  return operation == other.operation && same_given(inputs, other.inputs) && same_given(outputs, other.outputs) &&
         same_given(after, other.after);
}

Machine::Machine(const zed::Specification& specification, Setup setup)
    : parts_(std::make_unique<Parts>(specification, std::move(setup))) {}
Machine::~Machine() = default;

const Machine::Parts& Machine::parts() const { return *parts_; }
const std::string& Machine::state() const { return parts_->state; }
const std::string& Machine::init() const { return parts_->init; }
const std::vector<Name>& Machine::components() const { return parts_->components; }
const std::vector<MachineOperation>& Machine::operations() const { return parts_->operations; }

const MachineOperation* Machine::find(const std::string& name) const {
  const auto at = std::find_if(parts_->operations.begin(), parts_->operations.end(),
                               [&](const auto& operation) { return operation.name == name; });
  return at == parts_->operations.end() ? nullptr : &*at;
}

std::vector<std::string> Machine::carriers() const {
  std::vector<std::string> said;
  for (const auto& [set, members] : parts_->carriers) {
    said.push_back(set + " == {");
    for (std::size_t i = 0; i < members.size(); ++i) said.back() += (i > 0 ? ", " : "") + members[i];
    said.back() += "}";
  }
  return said;
}

std::vector<std::string> Machine::taken() const { return taken_lines(parts_->evaluator->taken()); }

ReachedTransitions Machine::initial(std::size_t most) const {
  parts_->begin_question();
  const Valuation none;
  Ways ways(*parts_, init().empty() ? state() : init(), none, most);
  ways.add(none);
  return ways.found();
}

ReachedTransitions Machine::steps(const Valuation& before, const MachineOperation& operation, const Valuation& inputs,
                                  std::size_t most) const {
  parts_->begin_question();
  Ways ways(*parts_, operation.name, before, most);
  Valuation known = before;
  known.insert(known.end(), inputs.begin(), inputs.end());
  std::vector<Name> looked_for;  // of the inputs that are not given, those that may come from a set without end
  for (const Name& input : operation.inputs)
    if (!value_of(inputs, input) && parts_->has_numbers(parts_->types.at(input))) looked_for.push_back(input);
  if (looked_for.empty() || !ways.add_listed(known)) ways.add_each(known, looked_for);
  return ways.found();
}

Truth Machine::is_step(const Valuation& before, const Transition& transition) const {
  parts_->begin_question();
  const zed::SchemaCheck& check = parts_->check(transition.operation);
  Valuation all = parts_->named(before, transition);
  if (!has_all(check.components(), {after_stroke(components().front())}))  // an initial schema of S itself
    all.insert(all.end(), transition.after.begin(), transition.after.end());
  return check.holds(in_order(check.components(), all));
}

std::vector<zed::ConjunctTruth> Machine::invariant(const Valuation& state_now) const {
  parts_->begin_question();
  const zed::SchemaCheck& check = parts_->check(state());
  return check.findings(in_order(check.components(), state_now));
}

std::vector<zed::ConjunctTruth> Machine::preconditions(const Valuation& before, const MachineOperation& operation,
                                                       const Valuation& inputs) const {
  parts_->begin_question();
  const zed::SchemaCheck& check = parts_->check(operation.name);
  Valuation all = before;
  all.insert(all.end(), inputs.begin(), inputs.end());
  return check.findings(in_order(check.components(), all));
}

std::vector<ConjectureResult> Machine::conjectures(const Valuation& before, const Transition& transition) const {
  std::vector<ConjectureResult> all;
  for (Parts::Claim& claim : parts_->claims) {
    ConjectureResult tried{claim.text, claim.place, Truth::open, false};
    const auto names = included_names(parts_->typing, claim.term);
    Valuation locals;
    if (names) {
      const Valuation available = has_all(components(), *names) ? transition.after : parts_->named(before, transition);
      tried.of_states = true;
      for (const Name& name : *names)
        if (const Value* value = value_of(available, name); value && !value_of(locals, name))
          locals.emplace_back(name, *value);
      const bool all_known = std::all_of(names->begin(), names->end(),
                                         [&](const Name& name) { return value_of(locals, name) != nullptr; });
      if (!all_known) continue;  // it speaks of another transition
    }
    if (!claim.truth) {
      tried.truth = parts_->truth(names ? claim_instance(claim.term) : claim.term, locals, claim);
      if (!names) claim.truth = tried.truth;
    } else {
      tried.truth = *claim.truth;
    }
    all.push_back(std::move(tried));
  }
  return all;
}

Value Machine::typed(const std::string& text, const Name& component) const {
  const zed::Term right = parsed(text, parts_->notation);
  const zed::Term equation = zed::relation({{"_=_", {}}}, {zed::reference(component, {}, right->place), right});
  auto locals = zed::calculator_names();
  locals.emplace_back(component, parts_->types.at(component));
  const zed::Typing typing = zed::check_term(parts_->typing, Parts::section_name, equation, locals, "VALUE");
  if (!typing.ok()) {
    const zed::Defect& first = typing.defects.front();
    throw zed::ZError(first.place, first.what, first.expected);
  }
  parts_->begin_question();
  Value value = parts_->evaluator->value(right);
  if (value.is_undefined() || value.is_open())
    throw zed::ZError(right->place, "this has no value", "expected a value for " + component.text());
  return value;
}

std::string Machine::written(const Name& component, const Value& value) const {
  const auto spelling = [](const zed::AtomName& atom) { return atom.text; };
  return value.text(parts_->types.at(component), spelling);
}

std::string Machine::type_text(const Name& component) const { return parts_->types.at(component).text(Type::max_size); }

}  // namespace durero::spec
