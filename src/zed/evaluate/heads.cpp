/// Compiles heads of comprehensions and quantifiers: the variables of a schema text, and the tuple that they make.

#include <algorithm>

#include "zed/evaluate/compiler.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {

void assign(Frame& frame, const std::vector<TupleComponent>& groups, const Value& value) {
  const auto give = [&](const TupleComponent& group, const Value& part) {
    frame.slots[group.slot] = part;
    if (!group.names) return;
    const BindingValue* binding = part.binding();
    for (std::size_t i = 0; i < group.components.size(); ++i) {
      const Value* component = nullptr;
      if (binding) {
        component = binding->names == group.names ? &binding->values[i] : binding->component((*group.names)[i]);
      }
      if (binding && !component) throw EvaluationError(part.text() + " has another type than its place");
      frame.slots[group.components[i]] = component ? *component : Value(Open{});
    }
  };
  if (groups.size() == 1) return give(groups[0], value);
  const auto* tuple = value.tuple();
  if (tuple && tuple->parts.size() != groups.size()) throw EvaluationError(value.text() + " has too many parts");
  for (std::size_t i = 0; i < groups.size(); ++i) give(groups[i], tuple ? tuple->parts[i] : Value(Open{}));
}

namespace {

template <class Part>
Value gathered(const std::vector<TupleComponent>& groups, Part&& part) {
  std::vector<Value> values;
  for (const TupleComponent& group : groups) {
    if (!group.names) {
      values.push_back(part(group.slot));
      continue;
    }
    std::vector<Value> components;
    components.reserve(group.components.size());
    for (const unsigned slot : group.components) components.push_back(part(slot));
    values.push_back(Value::binding(group.names, std::move(components)));
  }
  return values.size() == 1 ? std::move(values[0]) : Value::tuple(std::move(values));
}

}  // namespace

Value characteristic(const Frame& frame, const std::vector<TupleComponent>& groups) {
  return gathered(groups, [&](unsigned slot) { return frame.slots[slot]; });
}

Value unknown_characteristic(Frame& frame, const CompiledSchemaText& head) {
  return gathered(head.groups, [&](unsigned slot) -> Value {
    for (const Variable& variable : head.search->variables()) {
      if (variable.slot != slot || !variable.set) continue;
      const Value set = variable.set(frame);
      if (set.set()) return set.set()->unknown(frame.context);
    }
    return Unknown{frame.context.fresh()};
  });
}

/// Compiles an included schema, whose binding is in the slot `whole`. It sees its own components, and none of the
/// variables beside it.
Property Compiler::inclusion(const Declaration& included, unsigned whole, const Scope& scope, const Scope& inner) {
  Scope own{.outer = &scope, .unit = scope.unit, .thetas = inner.thetas, .declarations = &scope};
  for (const Name& name : zed::components(included, definitions_)) own.names[name] = inner.names.at(name);
  Property property;
  property.parts.push_back(predicate(included.term, own));
  const bool named = included.term->kind == Kind::reference && included.term->children.empty();
  if (const Meaning* schema = named ? definitions_.find(included.term->name) : nullptr) {
    property.whole = whole;
    property.schema = schema;
  }
  return property;
}

namespace {

/// Takes the slots before `end` away from what is compiled as long as this lives. The set of a variable is computed
/// again while a search goes on: its own variables leave those of the search alone.
class SlotsBeyond {
 public:
  SlotsBeyond(Unit& unit, unsigned end) : unit_(unit), before_(unit.next) { unit_.next = std::max(unit.next, end); }
  ~SlotsBeyond() { unit_.next = before_; }
  SlotsBeyond(const SlotsBeyond&) = delete;
  SlotsBeyond& operator=(const SlotsBeyond&) = delete;

 private:
  Unit& unit_;
  unsigned before_;
};

/// The names that a text declares have so many slots at most, with one more for each schema that it includes.
std::size_t slots_declared(const SchemaText& text, const Definitions& definitions) {
  std::size_t slots = 0;
  for (const Declaration& each : text.declarations)
    slots += each.form == Declaration::Form::included ? 1 + components(each, definitions).size() : each.names.size();
  return slots;
}

}  // namespace

CompiledSchemaText Compiler::head(const SchemaText& text, const Scope& scope, Scope& inner, const Term& extra) {
  CompiledSchemaText head;
  std::vector<Variable> variables;
  std::vector<Property> goal;
  std::vector<unsigned> wholes;
  const auto declare = [&](const Name& name, Code set) {
    const auto entry = inner.names.find(name);
    if (entry != inner.names.end()) return *entry->second.slot;
    const unsigned slot = Slots::take(*scope.unit);
    inner.names[name] = {slot, {}};
    Variable variable{.name = name.text(), .slot = slot, .set = std::move(set), .value = {}};
    variables.push_back(std::move(variable));
    return slot;
  };
  const unsigned end = scope.unit->next + static_cast<unsigned>(slots_declared(text, definitions_));
  const auto compiled = [&](const Term& term) {
    const SlotsBeyond beyond(*scope.unit, end);
    return expression(term, scope);
  };
  std::vector<const Declaration*> included;
  for (const Declaration& declaration : text.declarations) {
    if (declaration.form == Declaration::Form::typed) {
      const Code set = compiled(declaration.term);
      for (const Name& name : declaration.names) head.groups.push_back({declare(name, set), nullptr, {}});
    } else if (declaration.form == Declaration::Form::defined) {
      const std::size_t before = reads_.size();
      const Code value = compiled(declaration.term);
      const unsigned slot = declare(declaration.names[0], {});
      head.groups.push_back({slot, nullptr, {}});
      Property equation =
          test_of([slot, value](Frame& frame) { return equal(frame.slots[slot], value(frame), frame.context); });
      equation.equations.push_back({slot, value, {reads_.begin() + static_cast<std::ptrdiff_t>(before), reads_.end()}});
      goal.push_back(std::move(equation));
    } else {
      const std::string strokes = match::characteristic_strokes(declaration.term);
      auto names = zed::components(declaration, definitions_);
      for (Name& name : names) name.strokes = name.strokes.substr(0, name.strokes.size() - strokes.size());
      std::sort(names.begin(), names.end());
      TupleComponent group{Slots::take(*scope.unit), signature(names), {}};
      for (const Name& name : names) group.components.push_back(declare({name.word, name.strokes + strokes}, {}));
      wholes.push_back(group.slot);
      if (declaration.term->kind == Kind::reference) inner.thetas[declaration.term->name.text()] = group.slot;
      head.groups.push_back(std::move(group));
      included.push_back(&declaration);
    }
  }
  if (text.declarations.empty()) head.groups.push_back({Slots::take(*scope.unit), signature({}), {}});
  for (std::size_t i = 0; i < included.size(); ++i) goal.push_back(inclusion(*included[i], wholes[i], scope, inner));
  for (const Predicate& conjunct : text.predicates) goal.push_back(predicate(conjunct.term, inner));
  if (extra) goal.push_back(predicate(extra, inner));
  head.search = std::make_shared<const Solver>(std::move(variables), all_of(std::move(goal)), std::move(wholes));
  return head;
}

}  // namespace durero::zed
