/// Checks predicates.

#include <fmt/core.h>

#include "zed/syntax/symbols.hpp"
#include "zed/types/checker.hpp"

namespace durero::zed {

void Checker::predicate(const Term& term) {
  const Node& node = *term;
  const Place before = at_;
  at_ = node.place;
  switch (node.kind) {
    case Kind::truth:
    case Kind::falsity:
      break;
    case Kind::relation:
      relation(node);
      break;
    case Kind::negation:
    case Kind::conjunction:
    case Kind::disjunction:
    case Kind::implication:
    case Kind::equivalence:
      for (const Term& part : node.children) predicate(part);
      break;
    case Kind::forall:
    case Kind::exists:
    case Kind::exists_one:
      push(signature(*node.text));
      predicates(*node.text);
      predicate(node.children[0]);
      pop();
      break;
    case Kind::let:
      let(node, Mode::truth);
      break;
    default:
      schema_predicate(node, expression(term));
  }
  at_ = before;
}

void Checker::schema_predicate(const Node& node, const Type& type) {
  spend(type.size());
  if (type.is(Type::Kind::unknown) || awaits(node, type)) return;
  if (!type.is_schema_set())
    return error(node.place, fmt::format("an expression of type {} stands where a predicate is expected", type.text()),
                 "expected a predicate or a schema");
  const Type& schema = type.parts()[0];
  for (std::size_t i = 0; i < schema.fields().size(); ++i) {
    const Name& name = schema.fields()[i];
    const auto declared = component_in_scope(name, node.place);
    if (!declared) {
      error(node.place, name.text() + " is not declared", "expected the components of a schema predicate in scope");
    } else if (!unify(*declared, schema.parts()[i])) {
      error(node.place, fmt::format("{} has the type {}", name.text(), declared->text()),
            fmt::format("expected {}, as in the schema", schema.parts()[i].text()));
    }
  }
}

void Checker::relation(const Node& node) {
  std::vector<Type> types;
  types.reserve(node.children.size());
  for (const Term& operand : node.children) types.push_back(expression(operand));
  if (node.children.size() == 1) {
    const auto declared = lookup(node.names[0], nullptr, node.place);
    if (!declared) return error(node.place, node.names[0].text() + " is not declared", expected_name(node.names[0]));
    if (!unify(*declared, Type::power(types[0])))
      error(
          node.place, fmt::format("the operand has the type {}", types[0].text()),
          fmt::format("expected {}", declared->is(Type::Kind::power) ? declared->parts()[0].text() : declared->text()));
    return;
  }
  for (std::size_t i = 0; i + 1 < types.size(); ++i)
    relate(node.names[i], *node.children[i], types[i], *node.children[i + 1], types[i + 1]);
}

void Checker::relate(const Name& relation, const Node& left, const Type& a, const Node& right, const Type& b) {
  const Operator* op = operator_of_name(relation.word);
  const std::string symbol = op ? std::string(op->symbol) : relation.text();
  const auto mismatch = [&](const std::string& expected) {
    error(left.place, fmt::format("{} between {} and {}", symbol, a.text(), b.text()), expected);
  };
  if (relation.word == "_=_") {
    if (!unify(a, b)) mismatch("expected one type on both sides");
    return;
  }
  if (relation.word == "_∈_") {
    if (!unify(Type::power(a), b)) mismatch("expected on the right a set of what is on the left");
    return;
  }
  const auto declared = lookup(relation, nullptr, right.place);
  if (!declared) return error(left.place, symbol + " is not declared", expected_name(relation));
  const Type wanted = declared->is(Type::Kind::power) ? declared->parts()[0] : *declared;
  const std::string both = wanted.text();
  if (!unify(wanted, Type::product({a, b}))) mismatch(fmt::format("expected {}", both));
}

}  // namespace durero::zed
