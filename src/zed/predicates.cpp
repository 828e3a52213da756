/// Predicates to properties.

#include <algorithm>

#include "compiler.hpp"
#include "describe.hpp"
#include "functions.hpp"

namespace durero::zed {
namespace {

Truth negated(const Property& property, Frame& frame) {
  Necessary not_here(frame.context, false);
  return !evaluate(property, frame);
}

/// Not every way to satisfy the head satisfies the body: it is looked for one that does not.
Truth for_all(const Search& search, const Property& body, Frame& frame) {
  Necessary not_here(frame.context, false);
  Truth result = Truth::yes;
  const Truth some = search.each(frame, [&](Frame& inside) {
    const Truth here = evaluate(body, inside);
    if (here != Truth::yes) result = here;
    return here != Truth::no;
  });
  return result == Truth::yes && some == Truth::open ? some : result;
}

Truth just_one(const Head& head, Frame& frame) {
  Necessary not_here(frame.context, false);
  std::optional<Value> only;
  bool several = false;
  const Truth some = head.search->each(frame, [&](Frame& inside) {
    Value here = characteristic(inside, head.groups);
    several = only && !same(*only, here);
    only = std::move(here);
    return !several;
  });
  return several ? Truth::no : some;
}

}  // namespace

void assign(Frame& frame, const std::vector<Group>& groups, const Value& value) {
  const auto give = [&](const Group& group, const Value& part) {
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
Value gathered(const std::vector<Group>& groups, Part&& part) {
  std::vector<Value> values;
  for (const Group& group : groups) {
    if (!group.names) {
      values.push_back(part(group.slot));
      continue;
    }
    std::vector<Value> components;
    for (const unsigned slot : group.components) components.push_back(part(slot));
    values.push_back(Value::binding(group.names, std::move(components)));
  }
  return values.size() == 1 ? std::move(values[0]) : Value::tuple(std::move(values));
}

}  // namespace

Value characteristic(const Frame& frame, const std::vector<Group>& groups) {
  return gathered(groups, [&](unsigned slot) { return frame.slots[slot]; });
}

Value unknown_characteristic(Frame& frame, const Head& head) {
  return gathered(head.groups, [&](unsigned slot) -> Value {
    for (const Variable& one : head.search->variables()) {
      if (one.slot != slot || !one.set) continue;
      const Value set = one.set(frame);
      if (set.set()) return set.set()->unknown(frame.context);
    }
    return Unknown{frame.context.fresh()};
  });
}

Property Compiler::predicate(const Term& term, const Scope& scope) {
  const Node& node = *term;
  const auto part = [&](std::size_t i) { return predicate(node.children[i], scope); };
  switch (node.kind) {
    case Kind::truth:
      return all_of({});
    case Kind::falsity:
      return test_of([](Frame&) { return Truth::no; }, term);
    case Kind::relation:
      return relation(term, scope);
    case Kind::conjunction: {
      std::vector<Property> parts;
      parts.push_back(part(0));
      parts.push_back(part(1));
      return all_of(std::move(parts));
    }
    case Kind::disjunction: {
      Property made;
      made.kind = Property::Kind::any;
      made.parts.push_back(part(0));
      made.parts.push_back(part(1));
      return made;
    }
    case Kind::negation:
      return test_of([inner = part(0)](Frame& frame) { return negated(inner, frame); }, term);
    case Kind::implication:
      return test_of(
          [left = part(0), right = part(1)](Frame& frame) {
            const Truth not_left = negated(left, frame);
            if (not_left == Truth::yes) return not_left;
            Necessary only(frame.context, not_left == Truth::no);
            const Truth here = evaluate(right, frame);
            return here == Truth::yes ? here : not_left == Truth::open ? not_left : here;
          },
          term);
    case Kind::equivalence:
      return test_of(
          [left = part(0), right = part(1)](Frame& frame) {
            Necessary not_here(frame.context, false);
            const Truth a = evaluate(left, frame), b = evaluate(right, frame);
            return a == Truth::open || b == Truth::open ? Truth::open : truth(a == b);
          },
          term);
    case Kind::forall:
    case Kind::exists:
      return quantified(term, scope);
    case Kind::exists_one:
      return exists_one(node, scope);
    case Kind::let: {
      const Slots slots(*scope.unit);
      Scope inner{.outer = &scope, .unit = scope.unit};
      std::vector<std::pair<unsigned, Code>> defined;
      for (const Declaration& one : node.text->declarations) {
        const unsigned slot = Slots::one(*scope.unit);
        defined.emplace_back(slot, expression(one.term, scope));
        inner.names[one.names[0]] = {slot, {}};
      }
      return test_of(
          [defined, body = predicate(node.children[0], inner)](Frame& frame) {
            for (const auto& one : defined) frame.slots[one.first] = one.second(frame);
            return evaluate(body, frame);
          },
          term);
    }
    default:
      return schema_reference(term, scope);
  }
}

Property Compiler::relation(const Term& term, const Scope& scope) {
  const Node& node = *term;
  std::vector<Code> operands;
  std::vector<std::vector<unsigned>> reads;
  for (const Term& child : node.children) {
    const std::size_t before = reads_.size();
    operands.push_back(expression(child, scope));
    reads.emplace_back(reads_.begin() + static_cast<std::ptrdiff_t>(before), reads_.end());
  }
  std::vector<ToolkitRelation> relations;
  for (const Name& one : node.names) {
    relations.push_back(toolkit_relation(one.word));
    if (!relations.back()) cannot(node, "the evaluator knows no relation " + one.word);
  }
  if (operands.size() == 1)
    return test_of(
        [of = operands[0], holds = relations[0]](Frame& frame) { return holds(of(frame), {}, frame.context); }, term);
  if (relations.size() > 1) {
    return test_of(
        [operands, relations](Frame& frame) {
          Truth all = Truth::yes;
          Value left = operands[0](frame);
          for (std::size_t i = 0; i < relations.size(); ++i) {
            Value right = operands[i + 1](frame);
            const Truth here = relations[i](left, right, frame.context);
            if (here == Truth::no) return here;
            if (here == Truth::open) all = here;
            left = std::move(right);
          }
          return all;
        },
        term);
  }
  Property made = test_of(
      [left = operands[0], right = operands[1], holds = relations[0]](Frame& frame) {
        const Value a = left(frame);
        return holds(a, right(frame), frame.context);
      },
      term);
  if (node.names[0].word != "_=_") return made;
  for (const std::size_t side : {0U, 1U}) {
    const Node& variable = *node.children[side];
    const Local* local = variable.kind == Kind::reference ? find(variable.name, scope) : nullptr;
    if (local && local->slot) made.equations.push_back({*local->slot, operands[1 - side], reads[1 - side]});
  }
  return made;
}

Property Compiler::quantified(const Term& term, const Scope& scope) {
  const Node& node = *term;
  const Slots slots(*scope.unit);
  Scope inner{.outer = &scope, .unit = scope.unit};
  if (node.kind == Kind::exists) {
    const Head head = this->head(*node.text, scope, inner, node.children[0]);
    Property made;
    made.kind = Property::Kind::exists;
    made.search = head.search;
    made.term = term;
    return made;
  }
  const Head head = this->head(*node.text, scope, inner);
  return test_of([search = head.search,
                  body = predicate(node.children[0], inner)](Frame& frame) { return for_all(*search, body, frame); },
                 term);
}

Property Compiler::exists_one(const Node& node, const Scope& scope) {
  const Slots slots(*scope.unit);
  Scope inner{.outer = &scope, .unit = scope.unit};
  const Head head = this->head(*node.text, scope, inner, node.children[0]);
  return test_of([head](Frame& frame) { return just_one(head, frame); }, Term(std::make_shared<const Node>(node)));
}

Head Compiler::head(const SchemaText& text, const Scope& scope, Scope& inner, const Term& extra) {
  Head made;
  std::vector<Variable> variables;
  std::vector<Property> goal;
  std::vector<unsigned> wholes;
  const auto declare = [&](const Name& name, Code set) {
    const auto found = inner.names.find(name);
    if (found != inner.names.end()) return *found->second.slot;
    const unsigned slot = Slots::one(*scope.unit);
    inner.names[name] = {slot, {}};
    Variable variable{.name = name.text(), .slot = slot, .set = std::move(set), .value = {}};
    variables.push_back(std::move(variable));
    return slot;
  };
  std::vector<const Declaration*> included;
  for (const Declaration& one : text.declarations) {
    if (one.form == Declaration::Form::typed) {
      const Code set = expression(one.term, scope);
      for (const Name& name : one.names) made.groups.push_back({declare(name, set), nullptr, {}});
    } else if (one.form == Declaration::Form::defined) {
      const std::size_t before = reads_.size();
      const Code value = expression(one.term, scope);
      const unsigned slot = declare(one.names[0], {});
      made.groups.push_back({slot, nullptr, {}});
      Property equation =
          test_of([slot, value](Frame& frame) { return equal(frame.slots[slot], value(frame), frame.context); });
      equation.equations.push_back({slot, value, {reads_.begin() + static_cast<std::ptrdiff_t>(before), reads_.end()}});
      goal.push_back(std::move(equation));
    } else {
      auto names = zed::components(one, definitions_);
      std::sort(names.begin(), names.end());
      Group group{Slots::one(*scope.unit), signature(names), {}};
      for (const Name& name : names) group.components.push_back(declare(name, {}));
      wholes.push_back(group.slot);
      if (one.term->kind == Kind::reference) inner.thetas[one.term->name.text()] = group.slot;
      made.groups.push_back(std::move(group));
      included.push_back(&one);
    }
  }
  for (std::size_t i = 0; i < included.size(); ++i) {
    std::vector<Property> whole;
    whole.push_back(predicate(included[i]->term, inner));
    Property property;
    property.parts = std::move(whole);
    const Meaning* schema =
        included[i]->term->kind == Kind::reference ? definitions_.find(included[i]->term->name) : nullptr;
    if (schema && included[i]->term->children.empty()) {
      property.whole = wholes[i];
      property.schema = schema;
    }
    goal.push_back(std::move(property));
  }
  for (const Predicate& one : text.predicates) goal.push_back(predicate(one.term, inner));
  if (extra) goal.push_back(predicate(extra, inner));
  made.search = std::make_shared<const Search>(std::move(variables), all_of(std::move(goal)), std::move(wholes));
  return made;
}

}  // namespace durero::zed
