/// Compiles predicates to properties.

#include <algorithm>
#include <iterator>

#include "zed/evaluate/bounds.hpp"
#include "zed/evaluate/compiler.hpp"
#include "zed/evaluate/describe.hpp"
#include "zed/evaluate/linear_question.hpp"
#include "zed/evaluate/said_by_exists.hpp"
#include "zed/operators.hpp"
#include "zed/syntax/match.hpp"
#include "zed/value/toolkit_functions.hpp"

namespace durero::zed {
namespace {

using ToolkitRelation = decltype(Evaluation::relation);

/// Asks a relation of the toolkit. Membership takes the set as it is; other relations may list their operands.
Truth asked(ToolkitRelation holds, const Value& a, const Value& b, Context& context) {
  const bool membership = holds == relations::element_of || holds == relations::no_element_of;
  if (membership) context.steps.take();
  const Truth here = membership ? holds(a, b, context) : counted(holds, context, a, b);
  // No relation holds of an undefined value.
  return here == Truth::yes && (may_be_undefined(a) || may_be_undefined(b)) ? lost(context) : here;
}

Truth negated(const Property& property, Frame& frame) {
  const Necessary not_here(frame.context, false);
  return !evaluate(property, frame);
}

/// p ⇒ q is ¬ p ∨ q. The facts of q are required only where p holds.
Truth implied(const Property& left, const Property& right, Frame& frame) {
  const Truth not_left = negated(left, frame);
  if (not_left == Truth::yes) return not_left;
  const Necessary only(frame.context, not_left == Truth::no);
  const Truth right_truth = evaluate(right, frame);
  return right_truth != Truth::yes && not_left == Truth::open ? not_left : right_truth;
}

Truth equivalent(const Property& left, const Property& right, Frame& frame) {
  const Necessary not_here(frame.context, false);
  const Truth a = evaluate(left, frame), b = evaluate(right, frame);
  return a == Truth::open || b == Truth::open ? Truth::open : truth(a == b);
}

/// In a ≤ b < c each relation holds between the operands beside it.
Truth chained(const std::vector<Code>& operands, const std::vector<ToolkitRelation>& relations, Frame& frame) {
  Truth result = Truth::yes;
  Value left = operands[0](frame);
  for (std::size_t i = 0; i < relations.size(); ++i) {
    Value right = operands[i + 1](frame);
    result = both(result, asked(relations[i], left, right, frame.context));
    if (result == Truth::no) return result;
    left = std::move(right);
  }
  return result;
}

Property link(Code left, Code right, ToolkitRelation holds) {
  return test_of([left = std::move(left), right = std::move(right), holds](Frame& frame) {
    const HeldValue a(left, frame), b(right, frame);
    return asked(holds, *a, *b, frame.context);
  });
}

/// A ∀ is false where some way to satisfy the head does not satisfy the body: such a way is looked for.
Truth for_all(const Solver& search, const Property& body, Frame& frame) {
  const Necessary not_here(frame.context, false);
  Truth result = Truth::yes;
  const Truth some = search.each(frame, [&](Frame& inside) {
    const Truth here = evaluate(body, inside);
    if (here != Truth::yes) result = here;
    return here != Truth::no;
  });
  if (result != Truth::yes || some != Truth::open) return result;
  // The existence of a way that denies the body may be decided although the ways cannot be enumerated.
  try {
    return !search.exists(frame, [&](Frame& inside) {
      const Necessary nothing_of_it(inside.context, false);
      return !evaluate(body, inside);
    });
  } catch (const EvaluationError&) {
    return Truth::open;
  }
}

/// A ∀ that the search does not decide may be decided by linear conditions.
Truth for_all(const Solver& search, const Property& body, const LinearQuestion* linear, Frame& frame) {
  if (!linear) return for_all(search, body, frame);
  const Test denies = [&](Frame& inside) {
    const Truth in_head = search.holds(inside);
    return in_head == Truth::no ? in_head : both(in_head, !evaluate(body, inside));
  };
  return !searched([&] { return !for_all(search, body, frame); }, linear, frame, denies);
}

/// Asks a property that says the same where a test is not decided.
Test or_else(Test first, Property second) {
  return [first = std::move(first), second = std::move(second)](Frame& frame) {
    return first_decided([&] { return first(frame); },
                         [&] {
                           const Necessary not_here(frame.context, false);
                           return evaluate(second, frame);
                         });
  };
}

Truth just_one(const CompiledSchemaText& head, Frame& frame) {
  const Necessary not_here(frame.context, false);
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
      Property property;
      property.kind = Property::Kind::any;
      property.parts.push_back(part(0));
      property.parts.push_back(part(1));
      return property;
    }
    case Kind::negation:
      return test_of([inner = part(0)](Frame& frame) { return negated(inner, frame); }, term);
    case Kind::implication:
      return test_of([left = part(0), right = part(1)](Frame& frame) { return implied(left, right, frame); }, term);
    case Kind::equivalence:
      return test_of([left = part(0), right = part(1)](Frame& frame) { return equivalent(left, right, frame); }, term);
    case Kind::forall:
    case Kind::exists:
      return quantified(term, scope);
    case Kind::exists_one:
      return exists_one(node, scope);
    case Kind::let:
      return let_predicate(term, scope);
    default:
      return schema(term, scope);
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
  for (const Name& name : node.names) {
    const OperatorRow* row = operator_row(name.word);
    if (row && row->evaluation.property && operands.size() == 1)
      return test_of([of = operands[0], holds = row->evaluation.property](
                         Frame& frame) { return counted(holds, frame.context, of(frame)); },
                     term);
    if (!row || !row->evaluation.relation || operands.size() == 1)
      cannot(node, "the evaluator knows no relation " + name.word);
    relations.push_back(row->evaluation.relation);
  }
  std::vector<unsigned> depends;
  for (const std::vector<unsigned>& each : reads) depends.insert(depends.end(), each.begin(), each.end());
  if (relations.size() > 1) {
    Property chain = test_of([operands, relations](Frame& frame) { return chained(operands, relations, frame); }, term);
    chain.depends = std::move(depends);
    for (std::size_t i = 0; i < relations.size(); ++i) {
      chain.links.push_back(link(operands[i], operands[i + 1], relations[i]));
      add_bounds(chain.bounds,
                 {node.names[i].word, {node.children[i], operands[i]}, {node.children[i + 1], operands[i + 1]}}, scope);
    }
    return chain;
  }
  Property property = link(operands[0], operands[1], relations[0]);
  property.term = term;
  const auto is_toolkit = [&](const Name& name) { return !find(name, scope) && !definitions_.find(name); };
  if (const auto other = emptiness_by_exists(node, is_toolkit))
    property.test = by_numbers(property.test, *other, scope);
  add_bounds(property.bounds, {node.names[0].word, {node.children[0], operands[0]}, {node.children[1], operands[1]}},
             scope);
  property.depends = std::move(depends);
  if (!match::is_equation(term)) return property;
  for (const std::size_t side : {0U, 1U}) {
    const Node& variable = *node.children[side];
    const Local* local = variable.kind == Kind::reference ? find(variable.name, scope) : nullptr;
    if (local && local->slot) property.equations.push_back({*local->slot, operands[1 - side], reads[1 - side]});
    for (const char* span : {"dom", "ran"}) {
      const Term* of = match::argument_of(node.children[side], span);
      const Local* relation = of && (*of)->kind == Kind::reference ? find((*of)->name, scope) : nullptr;
      if (relation && relation->slot) property.spans.push_back({*relation->slot, operands[1 - side], reads[1 - side]});
    }
  }
  return property;
}

void Compiler::add_bounds(std::vector<ValueBound>& to, const RelationOf& relation, const Scope& scope) const {
  const auto slot = [&](const Term& term) -> std::optional<unsigned> {
    const Local* local = term->kind == Kind::reference && term->children.empty() ? find(term->name, scope) : nullptr;
    return local ? local->slot : std::nullopt;
  };
  const auto is_toolkit = [&](const Name& name) { return !find(name, scope) && !definitions_.find(name); };
  std::vector<ValueBound> found = bounds_of(relation, slot, is_toolkit);
  std::move(found.begin(), found.end(), std::back_inserter(to));
}

Property Compiler::quantified(const Term& term, const Scope& scope) {
  const Node& node = *term;
  const Slots slots(*scope.unit);
  Scope inner{.outer = &scope, .unit = scope.unit};
  if (node.kind == Kind::exists) {
    const CompiledSchemaText head = this->head(*node.text, scope, inner, node.children[0]);
    Property property;
    property.kind = Property::Kind::exists;
    property.search = head.search;
    property.linear = linear(node, scope, inner);
    property.term = term;
    return property;
  }
  const CompiledSchemaText head = this->head(*node.text, scope, inner);
  return test_of([search = head.search, body = predicate(node.children[0], inner), linear = linear(node, scope, inner)](
                     Frame& frame) { return for_all(*search, body, linear.get(), frame); },
                 term);
}

/// The question of whole numbers that a quantifier asks, if it asks one.
std::shared_ptr<const LinearQuestion> Compiler::linear(const Node& quantifier, const Scope& scope, const Scope& inner) {
  const LinearSurroundings around{[&](const Name& name) { return !find(name, scope) && !definitions_.find(name); },
                                  [&](const Name& name) -> const Term* {
                                    const Meaning* meaning = find(name, scope) ? nullptr : definitions_.find(name);
                                    const auto* form =
                                        meaning ? std::get_if<Definition>(&meaning->paragraph->form) : nullptr;
                                    return form && form->formals.empty() ? &form->value : nullptr;
                                  },
                                  [&](const Declaration& declaration) { return components(declaration, definitions_); },
                                  [&](const Term& term) { return expression(term, scope); },
                                  [&](const Name& name) { return *inner.names.at(name).slot; },
                                  [&](const Node& one) { return just_one_by_exists(one, definitions_); }};
  return linear_question(quantifier, around);
}

Property Compiler::exists_one(const Node& node, const Scope& scope) {
  const Slots slots(*scope.unit);
  Scope inner{.outer = &scope, .unit = scope.unit};
  const CompiledSchemaText head = this->head(*node.text, scope, inner, node.children[0]);
  Test test = [head](Frame& frame) { return just_one(head, frame); };
  if (const auto other = just_one_by_exists(node, definitions_)) test = by_numbers(std::move(test), *other, scope);
  return test_of(std::move(test), Term(std::make_shared<const Node>(node)));
}

/// A test, and where it is not decided a predicate that says the same, if that is an ∃ of whole numbers, or denies one.
Test Compiler::by_numbers(Test test, const Term& same, const Scope& scope) {
  const bool denied = same->kind == Kind::negation;
  Property exists = quantified(denied ? same->children[0] : same, scope);
  if (!exists.linear) return test;
  if (!denied) return or_else(std::move(test), std::move(exists));
  return or_else(std::move(test),
                 test_of([exists = std::move(exists)](Frame& frame) { return !evaluate(exists, frame); }));
}

}  // namespace durero::zed
