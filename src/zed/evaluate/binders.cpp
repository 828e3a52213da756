/// Compiles expressions that bind variables: let, { }, λ, μ, and a schema as the set that it is.

#include <set>

#include "zed/evaluate/compiler.hpp"
#include "zed/evaluate/intensional.hpp"
#include "zed/syntax/match.hpp"

namespace durero::zed {

void LetValues::give(Frame& frame) const {
  for (const auto& [slot, value] : slots_and_values) frame.slots[slot] = value(frame);
}

LetValues Compiler::let_values(const SchemaText& text, const Scope& scope, Scope& inner) {
  LetValues values;
  for (const Declaration& declaration : text.declarations) {
    const unsigned slot = Slots::take(*scope.unit);
    values.slots_and_values.emplace_back(slot, expression(declaration.term, scope));
    inner.names[declaration.names[0]] = {slot, {}};
  }
  return values;
}

Code Compiler::let(const Node& node, const Scope& scope) {
  const Slots slots(*scope.unit);
  Scope inner{.outer = &scope, .unit = scope.unit};
  const LetValues values = let_values(*node.text, scope, inner);
  return [values, body = expression(node.children[0], inner)](Frame& frame) {
    values.give(frame);
    return body(frame);
  };
}

Property Compiler::let_predicate(const Term& term, const Scope& scope) {
  const Slots slots(*scope.unit);
  Scope inner{.outer = &scope, .unit = scope.unit};
  const LetValues values = let_values(*term->text, scope, inner);
  return test_of(
      [values, body = predicate(term->children[0], inner)](Frame& frame) {
        values.give(frame);
        return evaluate(body, frame);
      },
      term);
}

std::vector<std::pair<std::string, unsigned>> Compiler::free_names(std::size_t before, unsigned base,
                                                                   const Scope& scope) const {
  std::vector<std::pair<std::string, unsigned>> free;
  std::set<unsigned> slots(reads_.begin() + static_cast<std::ptrdiff_t>(before), reads_.end());
  for (const Scope* here = &scope; here; here = here->outer) {
    std::map<std::string, unsigned> sorted;
    for (const auto& [name, local] : here->names)
      if (local.slot && *local.slot < base && slots.contains(*local.slot)) sorted.emplace(name.text(), *local.slot);
    for (const auto& [name, slot] : sorted)
      if (slots.erase(slot) != 0) free.emplace_back(name, slot);
  }
  for (const unsigned slot : slots)  // what no text can write, as between S and T in S ⨟ T
    if (slot < base) free.emplace_back("…", slot);
  return free;
}

Code Compiler::comprehension(const Node& node, const Scope& scope) {
  const unsigned base = scope.unit->next;
  const std::size_t before = reads_.size();
  const Slots slots(*scope.unit);
  Scope inner{.outer = &scope, .unit = scope.unit};
  const CompiledSchemaText head = this->head(*node.text, scope, inner);
  Code term;
  if (!node.children.empty()) term = expression(node.children[0], inner);
  return [head, term, base, unit = scope.unit, written = std::make_shared<const Node>(node),
          free = free_names(before, base, scope)](Frame& frame) -> Value {
    if (!head.search->enumerable(frame))
      return intensional_set({unit, captured(frame, base), head, term, written, free}, frame.context.steps);
    std::vector<Value> values;
    const Necessary no(frame.context, false);
    const Truth some = head.search->each(frame, [&](Frame& inside) {
      values.push_back(term ? term(inside) : characteristic(inside, head.groups));
      return true;
    });
    return some == Truth::open ? Value(Open{}) : Value::set(std::move(values));
  };
}

Code Compiler::schema_set(const Term& term, const Scope& scope) {
  if (!components(term, definitions_)) cannot(*term, "a predicate stands in the place of an expression");
  // The tuple of an included S ′ is θ S ′, without the strokes; that of the set S ′ itself, as of [S ′], has them.
  const auto including = [](const Term& schema) {
    SchemaText text;
    text.declarations.push_back({Declaration::Form::included, {}, {}, schema, schema->place});
    return text;
  };
  const bool stroked = !match::characteristic_strokes(term).empty();
  SchemaText text = including(stroked ? zed::quantified(Kind::schema_text, including(term), {}, term->place) : term);
  Node node{.kind = Kind::comprehension, .place = term->place, .name = {}, .children = {}, .names = {}, .text = {}};
  node.text = std::make_shared<const SchemaText>(std::move(text));
  return comprehension(node, scope);
}

Code Compiler::lambda(const Node& node, const Scope& scope) {
  const unsigned base = scope.unit->next;
  const std::size_t before = reads_.size();
  const Slots slots(*scope.unit);
  Scope inner{.outer = &scope, .unit = scope.unit};
  const CompiledSchemaText head = this->head(*node.text, scope, inner);
  Code term = expression(node.children[0], inner);
  return [head, term = std::move(term), base, unit = scope.unit, written = std::make_shared<const Node>(node),
          free = free_names(before, base, scope)](Frame& frame) {
    return lambda_function({unit, captured(frame, base), head, term, written, free}, frame.context.steps);
  };
}

Code Compiler::mu(const Node& node, const Scope& scope) {
  const Slots slots(*scope.unit);
  Scope inner{.outer = &scope, .unit = scope.unit};
  const CompiledSchemaText head = this->head(*node.text, scope, inner);
  Code term;
  if (!node.children.empty()) term = expression(node.children[0], inner);
  return [head, term = std::move(term)](Frame& frame) -> Value {
    std::optional<Value> only;
    bool several = false;
    const Necessary no(frame.context, false);
    const Truth some = head.search->each(frame, [&](Frame& inside) {
      Value here = term ? term(inside) : characteristic(inside, head.groups);
      several = only && !same(*only, here);
      only = std::move(here);
      return !several;
    });
    if (several || some == Truth::no) return {};
    if (some == Truth::open) return Open{};
    return *only;
  };
}

}  // namespace durero::zed
